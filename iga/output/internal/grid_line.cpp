#include "iga/output/internal/grid_line.hpp"

#include <algorithm>

#include "geometry/splines/basis.hpp"
#include "geometry/splines/transfer.hpp"

namespace isopatch::iga {
namespace {

// The knot spans from which a node is looked at.
std::vector<std::vector<int>> spans_of(const geometry::KnotVector& knots, const std::vector<double>& nodes) {
  const std::vector<double> breaks = knots.breaks();
  const std::vector<int> multiplicities = knots.multiplicities();
  std::vector<std::vector<int>> result;
  for (const double t : nodes) {
    std::vector<int> spans;
    const auto at = std::lower_bound(breaks.begin(), breaks.end(), t);
    const auto b = static_cast<std::size_t>(at - breaks.begin());
    const bool jumps = at != breaks.end() && *at == t && b > 0 && b + 1 < breaks.size() &&
                       multiplicities[b] >= knots.degree();
    if (jumps) spans.push_back(knots.span(0.5 * (breaks[b - 1] + t)));
    spans.push_back(knots.span(t));
    result.push_back(std::move(spans));
  }
  return result;
}

}  // namespace

GridLine grid_line(const geometry::KnotVector& knots, const std::vector<double>& nodes) {
  const std::vector<std::vector<int>> spans = spans_of(knots, nodes);
  GridLine line{nodes, {0}, {}, {}, {}};
  for (const std::vector<int>& of_node : spans) {
    line.begin.push_back(line.begin.back() + static_cast<int>(of_node.size()));
    for (const int span : of_node) line.first.push_back(span - knots.degree());
  }
  line.values.resize(line.begin.back(), knots.degree() + 1);
  line.derivatives.resize(line.begin.back(), knots.degree() + 1);
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const int span : spans[i]) {
      const Eigen::MatrixXd at = geometry::basis_on_span(knots, span, nodes[i], 1);
      line.values.row(row) = at.row(0);
      line.derivatives.row(row++) = at.row(1);
    }
  return line;
}

GridLine bezier_line(const geometry::KnotVector& knots) {
  const int p = knots.degree();
  const auto all = geometry::transfer(knots, geometry::bezier_knots(knots));
  const std::vector<double> breaks = knots.breaks();
  const Eigen::Index count = all.rows();
  GridLine line{{}, {0}, {}, GridLine::Rows(count, p + 1), GridLine::Rows::Zero(count, p + 1)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto e = std::min(static_cast<std::size_t>(i / p), breaks.size() - 2);
    line.first.push_back(knots.span(breaks[e]) - p);
    line.begin.push_back(static_cast<int>(i) + 1);
    line.nodes.push_back(breaks[e] + (breaks[e + 1] - breaks[e]) *
                                         static_cast<double>(i - static_cast<Eigen::Index>(e) * p) / p);
    for (int a = 0; a <= p; ++a) line.values(i, a) = all.coeff(i, line.first.back() + a);
  }
  return line;
}

}  // namespace isopatch::iga
