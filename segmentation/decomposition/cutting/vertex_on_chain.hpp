#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// The vertex at a point of a chain of edges, made where there is none.
/// @param point       on the chain, m
/// @param same_point  distance of what counts as one, m
VertexId vertex_on_chain(const geometry::Brep& source, geometry::CellComplex& complex,
                         const std::vector<geometry::EdgeUse>& chain, const Eigen::Vector3d& point,
                         double same_point);

}  // namespace isopatch::segmentation
