#include "iga/assembly/support_stiffness.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/splines/basis.hpp"
#include "iga/spaces/element_tables.hpp"
#include "iga/spaces/node_values.hpp"

namespace isopatch::iga {
namespace {

using Element = DirectionTable::Element;

constexpr int extra_points = 6;

// One element for each function, with its Greville point alone and the share of the line that is the
// function's.
DirectionTable greville_table(const geometry::KnotVector& knots) {
  const int degree = knots.degree();
  const std::vector<double> points = knots.greville();
  DirectionTable table;
  for (int i = 0; i < knots.size(); ++i) {
    const double point = std::clamp(points[static_cast<std::size_t>(i)], knots.first(), knots.last());
    const int span = knots.span(point);
    Element element;
    element.first = span - degree;
    element.nodes = Eigen::VectorXd::Constant(1, point);
    element.weights = Eigen::VectorXd::Constant(1, (knots.knots()[static_cast<std::size_t>(i + degree + 1)] -
                                                    knots.knots()[static_cast<std::size_t>(i)]) /
                                                       (degree + 1));
    const Eigen::MatrixXd at = geometry::basis_on_span(knots, span, point, 1);
    element.values = at.row(0);
    element.derivatives = at.row(1);
    table.elements.push_back(std::move(element));
  }
  return table;
}

// Whether the layer in which a parameter lies along direction 3 is one of a part.
bool has_layer_of(const PatchLayers& part, const geometry::KnotVector& knots,
                  const std::vector<double>& breaks, double parameter) {
  const auto behind = std::upper_bound(breaks.begin(), breaks.end(), parameter) - breaks.begin();
  const int layer = std::clamp(static_cast<int>(behind) - 1, 0, knots.element_count() - 1);
  return layer >= part.first_layer && layer < part.last_layer;
}

bool has_layer_of(const PatchLayers& part, const PatchSpace& space, double parameter) {
  return has_layer_of(part, space.knots[2], space.knots[2].breaks(), parameter);
}

// Keeps the elements of a table that have a point in the layers of a process's part.
void keep_layers(DirectionTable& table, const geometry::KnotVector& knots, const PatchLayers& part) {
  const std::vector<double> breaks = knots.breaks();
  std::erase_if(table.elements,
                [&](const Element& element) { return !has_layer_of(part, knots, breaks, element.nodes[0]); });
}

// The functions and the geometry of one face of a patch, and the elements of it that a part has.
class FaceOfPart {
 public:
  FaceOfPart(const PatchSpace& space, const PatchLayers& part, const SprungFace& sprung)
      : space_(space),
        sprung_(sprung),
        surface_(geometry::face_surface(*space.geometry, sprung.face.side)),
        nodes_(geometry::face_control_points(space.sizes(), sprung.face.side)) {
    const geometry::Side side = sprung.face.side;
    const auto directions = geometry::tangents(side);
    for (std::size_t d = 0; d < 2; ++d) {
      const geometry::KnotVector& knots = space.knots[static_cast<std::size_t>(directions[d])];
      tables_[d] = sprung.is_hold
                       ? greville_table(knots)
                       : direction_table(knots, geometry::gauss_legendre(knots.degree() + extra_points));
      counts_[d] = knots.size();
    }
    // Direction 3 is that in which patches are cut: across the face, or its second one.
    if (geometry::direction(side) == 2) {
      const int last = space.knots[2].element_count();
      const bool is_there =
          geometry::is_high(side) ? part.last_layer == last : part.first_layer == 0 && part.last_layer > 0;
      if (!is_there || part.first_layer == part.last_layer) tables_[1].elements.clear();
    } else {
      keep_layers(tables_[1], space.knots[2], part);
    }
  }

  // Calls visit(nodes of the element's functions, matrix of their products, ...) element by element.
  template <class Visit>
  void for_each_element(Visit visit) const {
    for (const Element& v : tables_[1].elements)
      for (const Element& u : tables_[0].elements) element(u, v, visit);
  }

 private:
  template <class Visit>
  void element(const Element& u, const Element& v, Visit visit) const {
    const auto along_u = static_cast<std::size_t>(u.values.cols());
    const auto count = along_u * static_cast<std::size_t>(v.values.cols());
    std::vector<int> nodes(count);
    std::vector<double> weights(count, 1.0);
    for (std::size_t a = 0; a < count; ++a) {
      const auto i = static_cast<int>(a % along_u), j = static_cast<int>(a / along_u);
      nodes[a] = nodes_[static_cast<std::size_t>(u.first + i + counts_[0] * (v.first + j))];
      if (space_.is_rational()) weights[a] = space_.weights[nodes[a]];
    }
    std::vector<Eigen::Matrix3d> sums(count * count, Eigen::Matrix3d::Zero());
    std::vector<double> values(count);
    for (Eigen::Index qv = 0; qv < v.nodes.size(); ++qv)
      for (Eigen::Index qu = 0; qu < u.nodes.size(); ++qu) {
        const geometry::Parameter<2> parameter(u.nodes[qu], v.nodes[qv]);
        const auto jacobian = surface_.jacobian(parameter);
        const Eigen::Vector3d area = Eigen::Vector3d(jacobian.col(0)).cross(Eigen::Vector3d(jacobian.col(1)));
        const double measure = area.norm();
        if (!(measure > 0)) continue;  // a collapsed edge rests on nothing
        const Eigen::Matrix3d springs = u.weights[qu] * v.weights[qv] * measure *
                                        sprung_.stiffness(surface_.point(parameter), area / measure);
        double denominator = 0;
        for (std::size_t a = 0; a < count; ++a) {
          values[a] = weights[a] * u.values(qu, static_cast<Eigen::Index>(a % along_u)) *
                      v.values(qv, static_cast<Eigen::Index>(a / along_u));
          denominator += values[a];
        }
        for (double& value : values) value /= denominator;
        for (std::size_t a = 0; a < count; ++a)
          for (std::size_t b = a; b < count; ++b) sums[a * count + b] += values[a] * values[b] * springs;
      }
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = a; b < count; ++b) visit(nodes[a], nodes[b], sums[a * count + b]);
  }

  const PatchSpace& space_;
  const SprungFace& sprung_;
  geometry::NurbsSurface surface_;
  std::vector<int> nodes_;
  std::array<DirectionTable, 2> tables_;
  std::array<int, 2> counts_ = {0, 0};
};

}  // namespace

NodeBlocks support_stiffness(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                             const Springs& springs) {
  if (springs.empty()) return {};
  BlockSums sums;
  const std::vector<int> first_node = first_nodes(spaces);
  for (const PatchLayers& part : parts) {
    const auto p = static_cast<std::size_t>(part.patch);
    const int first = first_node[p];
    for (const SprungFace& sprung : springs.faces)
      if (sprung.face.patch.value == part.patch)
        FaceOfPart(spaces[p], part, sprung).for_each_element([&](int a, int b, const Eigen::Matrix3d& value) {
          sums.add(first + a, first + b, value);
        });
    for (const SprungPoint& sprung : springs.points) {
      if (sprung.place.patch.value != part.patch || !has_layer_of(part, spaces[p], sprung.place.parameter[2]))
        continue;
      const std::vector<NodeValue> values = node_values(spaces[p], sprung.place.parameter);
      for (std::size_t a = 0; a < values.size(); ++a)
        for (std::size_t b = a; b < values.size(); ++b)
          sums.add(first + values[a].node, first + values[b].node,
                   values[a].value * values[b].value * sprung.stiffness);
    }
  }
  return sums.blocks();
}

}  // namespace isopatch::iga
