#pragma once

#include <vector>

#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

// Exact operations on a complex: what is shared stays shared, whatever belonged to a face of the source still
// does. None computes a shape.

/// Puts a vertex on an edge: it becomes the first part, a new edge the second, in all outlines.
/// @param t      in (0, 1) of the edge
/// @param point  of the edge there, m
VertexId divide_edge(geometry::CellComplex& complex, EdgeId edge, double t, const Eigen::Vector3d& point);

/// Puts an edge between two vertices of a face's outline: the face keeps what lies to the left of it, a new
/// face gets the rest. In each cell that the face bounds the new one belongs to the same side.
/// @param curve  from `from` to `to` over [0, 1]
/// @throws Error invalid_argument  vertices that are not on the outline, or that are one
EdgeId divide_face(geometry::CellComplex& complex, FaceId face, VertexId from, VertexId to,
                   geometry::CurveId curve);

/// Puts a face into a cell along a closed walk on its boundary: the cell keeps what lies to the left of the
/// walk, a new cell gets the rest. The new face looks to what the cell keeps. Sides that the walk cuts are
/// sides of both.
/// @param walk  edges one after the other
/// @param surface  through all of them
/// @throws Error invalid_argument  a walk that does not take the boundary apart
struct DividedCell {
  FaceId face;
  geometry::CellId other;
};
DividedCell divide_cell(geometry::CellComplex& complex, geometry::CellId cell,
                        const std::vector<geometry::EdgeUse>& walk, geometry::SurfaceId surface);

}  // namespace isopatch::segmentation
