#pragma once

#include <array>

namespace isopatch::geometry {

/// The place of a point of a hexahedron of any degree in VTK's order: corners, points of edges, of faces, of
/// the inside.
/// @param place   of the point along the three directions, each 0 .. degree
/// @source  VTK 9.1, vtkHigherOrderHexahedron::PointIndexFromIJK; version 2.2 of its files
int vtk_cell_point(const std::array<int, 3>& place, const std::array<int, 3>& degree);

}  // namespace isopatch::geometry
