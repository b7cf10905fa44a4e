#pragma once

#include <optional>
#include <string>
#include <vector>

#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

struct CutOptions {
  /// That surfaces through curved edges may deviate from them, as a share of the solid's size. Range (0,
  /// 1e-3).
  double tolerance = 1e-9;
  /// Smallest angle between a cut and a side, and between an auxiliary edge and the outline of its side.
  /// Range (0, 45 degrees).
  Angle smallest_angle = Angle::degrees(5);
  /// Edges of a larger angle inside a cell are to be cut through. Range (90, 180] degrees.
  Angle largest_angle = Angle::degrees(170);
  /// Shortest edge made, as a share of the solid's size. Range (0, 0.1).
  double shortest_edge = 2e-3;
  /// Cells with plane sides and straight edges are cut by planes only, so that planes always cut their
  /// pieces.
  bool keep_plane = true;
  /// Cells with other sides: auxiliary edges may be bent where straight ones are not free, and surfaces run
  /// through loops of five steps and more that lie in no plane.
  bool free_form = false;
  SideOptions sides = {};
  bool operator==(const CutOptions&) const = default;
};
void validate(const CutOptions& options);

/// A loop on the sides of a cell, and where its auxiliary vertices are.
struct PlacedLoop {
  CuttingLoop loop;
  /// By place: the vertex of the complex, if it is there already; by default, or where it is -1, the one of a
  /// divided edge that is nearest to its middle, or a new one in the middle.
  std::vector<VertexId> at = {};
  /// By place: where an auxiliary vertex is to be that `at` does not give, m; or empty.
  std::vector<Eigen::Vector3d> points = {};
};

/// What came of a cut.
struct CutCell {
  geometry::CellComplex complex;
  geometry::CellId left, right;  ///< of the loop, seen from outside; the left one keeps its number
  FaceId face;                   ///< between them
  std::vector<VertexId> places;  ///< of the loop
};

/// A cut, or why there is none.
struct CutAttempt {
  std::optional<CutCell> cut;
  std::string refusal = {};  ///< in words
};

/// Cuts one cell along a loop on its sides: auxiliary edges are put across the sides, a surface through all
/// of the loop.
///
/// Checked: the surface stays inside the cell, meets the sides at no small angle, and makes no short edge.
/// What lies outside of the cell is not changed, but that sides which it shares are divided.
/// @param sides  of the cell
/// @param boundary  `boundary_triangles` of the cell, where the caller keeps them
/// @cost  one triangulation of the cell, if the surface could leave it and `boundary` is not given
CutAttempt cut_cell(const geometry::Brep& source, geometry::CellComplex complex, geometry::CellId cell,
                    const CellSides& sides, const PlacedLoop& loop, const CutOptions& options = {},
                    const Eigen::Matrix3Xd* boundary = nullptr);

}  // namespace isopatch::segmentation
