#include "iga/spaces/element_tables.hpp"

#include "geometry/splines/basis.hpp"

namespace isopatch::iga {
DirectionTable direction_table(const geometry::KnotVector& knots, const geometry::QuadratureRule& rule) {
  DirectionTable table;
  const std::vector<double> breaks = knots.breaks();
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e) {
    const double length = breaks[e + 1] - breaks[e];
    DirectionTable::Element element;
    element.nodes = breaks[e] + length * rule.nodes.array();
    element.weights = length * rule.weights;
    element.values.resize(rule.nodes.size(), knots.degree() + 1);
    element.derivatives.resize(rule.nodes.size(), knots.degree() + 1);
    // A point on the element's high end belongs to the next span; a hair before it the span is right, and the
    // polynomials of that span are then evaluated at the point itself.
    const int span = knots.span(0.5 * (breaks[e] + breaks[e + 1]));
    element.first = span - knots.degree();
    for (Eigen::Index q = 0; q < rule.nodes.size(); ++q) {
      const Eigen::MatrixXd at = geometry::basis_on_span(knots, span, element.nodes[q], 1);
      element.values.row(q) = at.row(0);
      element.derivatives.row(q) = at.row(1);
    }
    table.elements.push_back(std::move(element));
  }
  return table;
}

namespace {

std::array<geometry::QuadratureRule, 3> gauss_rules(const geometry::NurbsVolume& patch, int points) {
  std::array<geometry::QuadratureRule, 3> rules;
  for (int d = 0; d < 3; ++d)
    rules[static_cast<std::size_t>(d)] = geometry::gauss_legendre(points > 0 ? points : patch.degree(d) + 1);
  return rules;
}

}  // namespace

ElementTables::ElementTables(const geometry::NurbsVolume& patch, int points)
    : ElementTables(patch, gauss_rules(patch, points)) {}

ElementTables::ElementTables(const geometry::NurbsVolume& patch,
                             const std::array<geometry::QuadratureRule, 3>& rules) {
  for (std::size_t d = 0; d < 3; ++d) directions_[d] = direction_table(patch.knots()[d], rules[d]);
}

std::int64_t ElementTables::element_count() const {
  std::int64_t count = 1;
  for (const DirectionTable& table : directions_) count *= static_cast<std::int64_t>(table.elements.size());
  return count;
}

geometry::Parameter<3> ElementTables::parameter(std::int64_t element, Eigen::Index point) const {
  const auto directions = of(element);
  geometry::Parameter<3> result;
  for (int d = 0; d < 3; ++d) {
    const Eigen::VectorXd& nodes = directions[static_cast<std::size_t>(d)]->nodes;
    result[d] = nodes[point % nodes.size()];
    point /= nodes.size();
  }
  return result;
}

}  // namespace isopatch::iga
