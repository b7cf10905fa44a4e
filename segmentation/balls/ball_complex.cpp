#include "segmentation/balls/internal/ball_complex.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"
#include "segmentation/balls/internal/cube_sides.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::EdgeUse;
using geometry::NurbsCurve;
using geometry::NurbsSurface;
using geometry::SurfaceId;

/// Of the way from the middle to a corner: how far the inner hexahedron reaches.
constexpr double inner_share = 0.55;

using Loop = std::array<int, 4>;  // corners; those of the inner hexahedron count from 8

/// The border of a side from its corner i to the next.
NurbsCurve border(const NurbsSurface& side, std::size_t i) {
  const Eigen::Index n = side.size(0), m = side.size(1);
  const bool along_u = i % 2 == 0;
  Eigen::Matrix3Xd points(3, along_u ? n : m);
  for (Eigen::Index k = 0; k < points.cols(); ++k)
    points.col(k) =
        side.control_points().col(along_u ? k + n * (i == 0 ? 0 : m - 1) : (i == 1 ? n - 1 : 0) + n * k);
  const NurbsCurve result({side.knots(along_u ? 0 : 1)}, points);
  return i < 2 ? result : geometry::reversed(result, 0);
}

class BallComplex {
 public:
  BallComplex(const OuterSides& outer, const Eigen::Vector3d& centre) : outer_(outer) {
    for (int corner = 0; corner < 8; ++corner) complex_.add_vertex(outer_corner(corner));
    for (int corner = 0; corner < 8; ++corner)
      complex_.add_vertex(centre + inner_share * (outer_corner(corner) - centre));
  }

  CellComplex make() {
    for (std::size_t s = 0; s < cube_sides.size(); ++s) add_outer_cell(s);
    geometry::Cell middle;
    for (std::size_t s = 0; s < cube_sides.size(); ++s)
      middle.faces.push_back({inner_[s], false, static_cast<int>(s)});
    complex_.cells.push_back(std::move(middle));
    return std::move(complex_);
  }

 private:
  Eigen::Vector3d outer_corner(int corner) const {
    for (std::size_t s = 0; s < cube_sides.size(); ++s)
      for (std::size_t i = 0; i < 4; ++i)
        if (cube_sides[s][i] == corner) return border(outer_[s], i).control_points().col(0);
    return {};
  }

  const Eigen::Vector3d& place(int corner) const { return complex_.vertex(VertexId(corner)); }

  /// Straight but on the outer sides, of which `curve` is a border.
  EdgeUse edge(int from, int to, const NurbsCurve* curve = nullptr) {
    const auto [known, fresh] = edges_.try_emplace(std::minmax(from, to), EdgeId(0), from);
    if (fresh)
      known->second.first = curve ? complex_.add_edge({*curve}, VertexId(from), VertexId(to))
                                  : complex_.add_straight_edge(VertexId(from), VertexId(to));
    return {known->second.first, known->second.second != from};
  }

  /// Runs as it is used.
  NurbsCurve shape(const EdgeUse& use) const {
    const NurbsCurve& made = std::get<NurbsCurve>(complex_.curve(complex_.edge(use.edge).curve).shape);
    return use.reversed ? geometry::reversed(made, 0) : made;
  }

  /// On a surface over the unit square whose corners are those of the loop, in its order.
  FaceId add_face(const NurbsSurface& surface, const std::array<EdgeUse, 4>& loop,
                  std::optional<FaceId> origin) {
    const SurfaceId made = complex_.add_surface(surface);
    const std::array<Eigen::Vector3d, 5> corners{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}};
    for (std::size_t i = 0; i < 4; ++i)
      complex_.add_trace(loop[i], made, geometry::segment(corners[i], corners[i + 1]));
    return complex_.add_face({made, {loop.begin(), loop.end()}, origin});
  }

  FaceId outer_face(std::size_t side) {
    std::array<EdgeUse, 4> loop;
    for (std::size_t i = 0; i < 4; ++i) {
      const NurbsCurve curve = border(outer_[side], i);
      loop[i] = edge(cube_sides[side][i], cube_sides[side][(i + 1) % 4], &curve);
    }
    return add_face(outer_[side], loop, FaceId(0));
  }

  FaceId inner_face(std::size_t side) {
    std::array<EdgeUse, 4> loop;
    for (std::size_t i = 0; i < 4; ++i)
      loop[i] = edge(cube_sides[side][i] + 8, cube_sides[side][(i + 1) % 4] + 8);
    const NurbsCurve back = geometry::reversed(shape(loop[2]), 0);
    return add_face(geometry::ruled(shape(loop[0]), back), loop, std::nullopt);
  }

  /// Between an outer edge and the inner one below it, made once; looks to the right of the way on which it
  /// is first asked for, as one walks there outside.
  geometry::CellFaceUse wall(int from, int to, int number) {
    const auto [known, fresh] = walls_.try_emplace(std::minmax(from, to), FaceId(0), from);
    if (fresh) {
      const std::array<EdgeUse, 4> loop = {edge(from + 8, to + 8), edge(to + 8, to), edge(to, from),
                                           edge(from, from + 8)};
      known->second.first = add_face(geometry::ruled(shape(loop[0]), geometry::reversed(shape(loop[2]), 0)),
                                     loop, std::nullopt);
    }
    return {known->second.first, known->second.second != from, number};
  }

  void add_outer_cell(std::size_t side) {
    geometry::Cell cell;
    cell.faces.push_back({outer_face(side), false, 0});
    inner_[side] = inner_face(side);
    cell.faces.push_back({inner_[side], true, 1});
    for (std::size_t i = 0; i < 4; ++i)
      cell.faces.push_back(wall(cube_sides[side][i], cube_sides[side][(i + 1) % 4], static_cast<int>(i) + 2));
    complex_.cells.push_back(std::move(cell));
  }

  const OuterSides& outer_;
  CellComplex complex_;
  std::map<std::pair<int, int>, std::pair<EdgeId, int>> edges_;  // and the corner where each begins
  std::map<std::pair<int, int>, std::pair<FaceId, int>> walls_;
  std::array<FaceId, 6> inner_;
};

}  // namespace

CellComplex ball_complex(const OuterSides& outer, const Eigen::Vector3d& centre) {
  return BallComplex(outer, centre).make();
}

}  // namespace isopatch::segmentation
