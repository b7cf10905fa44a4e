#include "segmentation/branches/internal/column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::CellId;
using geometry::EdgeUse;

class ColumnWalk {
 public:
  ColumnWalk(const CellComplex& complex, const PlanView& view) : complex_(complex), view_(view) {
    cells_at_.resize(complex.faces.size());
    for (std::size_t c = 0; c < complex.cells.size(); ++c)
      for (const geometry::CellFaceUse& use : complex.cells[c].faces)
        cells_at_[static_cast<std::size_t>(use.face.value)].emplace_back(static_cast<int>(c));
  }

  Column below(FaceId first) {
    made_.layers.push_back(layer_of(first));
    for (std::optional<CellId> cell = other_cell(first, {}); cell;
         cell = other_cell(made_.layers.back().face, cell))
      go_down(*cell);
    return std::move(made_);
  }

  bool is_outer(FaceId face) const { return cells_at_[static_cast<std::size_t>(face.value)].size() == 1; }

 private:
  std::optional<CellId> other_cell(FaceId face, std::optional<CellId> known) const {
    for (const CellId cell : cells_at_[static_cast<std::size_t>(face.value)])
      if (!known || cell != *known) return cell;
    return std::nullopt;
  }

  /// Turned to run counterclockwise.
  ColumnLayer layer_of(FaceId face) const {
    std::vector<EdgeUse> loop = complex_.face(face).loop;
    double twice_area = 0;
    for (const EdgeUse& use : loop) {
      const Eigen::Vector2d a = view_.flat(complex_.vertex(complex_.from(use))),
                            b = view_.flat(complex_.vertex(complex_.to(use)));
      twice_area += a.x() * b.y() - a.y() * b.x();
    }
    if (twice_area < 0) {
      std::reverse(loop.begin(), loop.end());
      for (EdgeUse& use : loop) use.reversed = !use.reversed;
    }
    ColumnLayer result{face, {}, {}};
    for (std::size_t i = 0; i < 4; ++i) {
      result.sides[i] = loop[i];
      result.corners[i] = complex_.from(loop[i]);
    }
    return result;
  }

  void go_down(CellId cell) {
    const ColumnLayer& top = made_.layers.back();
    std::array<geometry::CellFaceUse, 4> walls;
    std::array<EdgeUse, 4> uprights;
    ColumnLayer bottom;
    for (const geometry::CellFaceUse& use : complex_.cell(cell).faces) {
      if (use.face == top.face) continue;
      std::optional<std::size_t> side;
      for (const EdgeUse& edge : complex_.face(use.face).loop)
        for (std::size_t i = 0; i < 4; ++i)
          if (edge.edge == top.sides[i].edge) side = i;
      if (side)
        walls[*side] = use;
      else
        bottom.face = use.face;
    }
    for (std::size_t i = 0; i < 4; ++i) uprights[i] = upright(walls[i].face, top, bottom.face, i);
    for (std::size_t i = 0; i < 4; ++i) bottom.corners[i] = complex_.from(uprights[i]);
    for (const EdgeUse& use : complex_.face(bottom.face).loop)
      for (std::size_t i = 0; i < 4; ++i) {
        const VertexId from = bottom.corners[i], to = bottom.corners[(i + 1) % 4];
        if (complex_.from(use) == from && complex_.to(use) == to) bottom.sides[i] = use;
        if (complex_.from(use) == to && complex_.to(use) == from) bottom.sides[i] = {use.edge, !use.reversed};
      }
    made_.cells.push_back(cell);
    made_.walls.push_back(walls);
    made_.uprights.push_back(uprights);
    made_.layers.push_back(bottom);
  }

  /// The edge of a wall that ends at a corner of the top and is not of it.
  EdgeUse upright(FaceId wall, const ColumnLayer& top, FaceId bottom, std::size_t corner) const {
    std::set<EdgeId> across;
    for (const FaceId face : {top.face, bottom})
      for (const EdgeUse& use : complex_.face(face).loop) across.insert(use.edge);
    for (const EdgeUse& use : complex_.face(wall).loop) {
      if (across.contains(use.edge)) continue;
      if (complex_.edge(use.edge).end == top.corners[corner]) return {use.edge, false};
      if (complex_.edge(use.edge).start == top.corners[corner]) return {use.edge, true};
    }
    throw Error(ErrorCode::internal, "a hexahedron's side has no edge at a corner of its top");
  }

  const CellComplex& complex_;
  const PlanView& view_;
  std::vector<std::vector<CellId>> cells_at_;
  Column made_;
};

bool has_corners(const CellComplex& complex, const geometry::CellFace& face,
                 const std::array<Eigen::Vector3d, 4>& corners, double tolerance) {
  return face.loop.size() == 4 &&
         std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& corner) {
           return std::any_of(face.loop.begin(), face.loop.end(), [&](const EdgeUse& use) {
             return (complex.vertex(complex.from(use)) - corner).norm() < tolerance;
           });
         });
}

}  // namespace

Column column_below(const CellComplex& complex, const PlanView& view,
                    const std::array<Eigen::Vector3d, 4>& corners, double tolerance) {
  ColumnWalk walk(complex, view);
  for (int f = 0; f < static_cast<int>(complex.faces.size()); ++f)
    if (walk.is_outer(FaceId(f)) &&
        has_corners(complex, complex.faces[static_cast<std::size_t>(f)], corners, tolerance))
      return walk.below(FaceId(f));
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : corners) middle += corner / 4;
  throw Error(
      ErrorCode::unsupported,
      fmt::format("the body's side at ({:.6g}, {:.6g}, {:.6g}) m, where a branch begins, is not one of a "
                  "hexahedron",
                  middle.x(), middle.y(), middle.z()));
}

}  // namespace isopatch::segmentation
