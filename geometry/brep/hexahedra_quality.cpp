#include "geometry/brep/hexahedra_quality.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <map>
#include <variant>

#include "geometry/base/error.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {
namespace {

/// A point and the derivative along a curve.
struct Place {
  Eigen::Vector3d point, along;
};

/// A hexahedron by its edges: four along each direction, each at one corner of the square of the other two.
class BlendedHexahedron {
 public:
  BlendedHexahedron(const CellComplex& complex, const Cell& cell) : complex_(complex) {
    const auto& bottom = complex.face(cell.faces.front().face).loop;
    std::array<VertexId, 4> low{VertexId(0), VertexId(0), VertexId(0), VertexId(0)}, high = low;
    for (std::size_t k = 0; k < 4; ++k) low[k] = complex.from(bottom.at(k));
    std::map<std::pair<VertexId, VertexId>, EdgeUse> between;
    for (const CellFaceUse& use : cell.faces)
      for (const EdgeUse& edge : complex.face(use.face).loop) {
        between.insert_or_assign({complex.from(edge), complex.to(edge)}, edge);
        between.insert_or_assign({complex.to(edge), complex.from(edge)}, EdgeUse{edge.edge, !edge.reversed});
      }
    for (std::size_t k = 0; k < 4; ++k)
      for (const auto& [ends, use] : between)
        if (ends.first == low[k] && std::find(low.begin(), low.end(), ends.second) == low.end()) {
          high[k] = ends.second;
          edges_[2][k] = use;
        }
    const auto edge = [&](VertexId from, VertexId to) { return between.at({from, to}); };
    edges_[0] = {edge(low[0], low[1]), edge(low[3], low[2]), edge(high[3], high[2]), edge(high[0], high[1])};
    edges_[1] = {edge(low[0], low[3]), edge(low[1], low[2]), edge(high[1], high[2]), edge(high[0], high[3])};
    for (std::size_t k = 0; k < 4; ++k)
      corners_[k] = complex.vertex(low[k]), corners_[k + 4] = complex.vertex(high[k]);
  }

  /// Scaled, without its sign.
  double jacobian(const Eigen::Vector3d& at) const {
    Eigen::Matrix3d d = Eigen::Matrix3d::Zero();
    for (int direction = 0; direction < 3; ++direction) {
      const int a = direction == 0 ? 1 : 0, b = direction == 2 ? 1 : 2;
      for (std::size_t k = 0; k < 4; ++k) {
        const Place place = on(edges_[static_cast<std::size_t>(direction)][k], at[direction]);
        const double sa = k == 1 || k == 2 ? 1 : 0, sb = k >= 2 ? 1 : 0;
        const double wa = sa > 0 ? at[a] : 1 - at[a], wb = sb > 0 ? at[b] : 1 - at[b];
        d.col(direction) += wa * wb * place.along;
        d.col(a) += (2 * sa - 1) * wb * place.point;
        d.col(b) += wa * (2 * sb - 1) * place.point;
      }
    }
    d -= 2 * straight(at);
    const double scale = d.col(0).norm() * d.col(1).norm() * d.col(2).norm();
    return scale > 0 ? d.determinant() / scale : 0;
  }

 private:
  Place on(const EdgeUse& use, double t) const {
    const auto* own = std::get_if<NurbsCurve>(&complex_.curve(complex_.edge(use.edge).curve).shape);
    if (own == nullptr) {
      const Eigen::Vector3d from = complex_.vertex(complex_.from(use)),
                            to = complex_.vertex(complex_.to(use));
      return {from + t * (to - from), to - from};
    }
    const NurbsCurve& curve = *own;
    const CellEdge& edge = complex_.edge(use.edge);
    const double share = use.reversed ? 1 - t : t, length = edge.high - edge.low;
    const Parameter<1> s(edge.low + share * length);
    const Eigen::Vector3d along = length * curve.jacobian(s).col(0);
    return {curve.point(s), use.reversed ? Eigen::Vector3d(-along) : along};
  }

  /// Derivatives of the trilinear map of the corners.
  Eigen::Matrix3d straight(const Eigen::Vector3d& at) const {
    Eigen::Matrix3d d = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < 8; ++k) {
      const std::size_t around = k % 4;
      const Eigen::Vector3d side(around == 1 || around == 2 ? 1 : -1, around >= 2 ? 1 : -1, k >= 4 ? 1 : -1);
      const Eigen::Vector3d w = ((side.array() > 0).select(at, Eigen::Vector3d::Ones() - at));
      d.col(0) += side[0] * w[1] * w[2] * corners_[k];
      d.col(1) += side[1] * w[0] * w[2] * corners_[k];
      d.col(2) += side[2] * w[0] * w[1] * corners_[k];
    }
    return d;
  }

  const CellComplex& complex_;
  std::array<std::array<EdgeUse, 4>, 3> edges_{};
  std::array<Eigen::Vector3d, 8> corners_;
};

}  // namespace

double least_quality(const CellComplex& complex) {
  double least = 1;
  for (const Cell& cell : complex.cells) {
    const BlendedHexahedron hexahedron(complex, cell);
    double low = 1, high = -1;  // whichever way its first face looks
    constexpr std::array shares{0.02, 0.34, 0.66, 0.98};
    for (const double u : shares)
      for (const double v : shares)
        for (const double w : shares) {
          const double found = hexahedron.jacobian({u, v, w});
          low = std::min(low, found), high = std::max(high, found);
        }
    least = std::min(least, std::max(low, -high));
  }
  return least;
}

}  // namespace isopatch::geometry
