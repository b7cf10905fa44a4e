#pragma once

#include "geometry/brep/opencascade/internal/shape_input.hpp"

namespace isopatch::geometry {

/// @param chord  largest distance to the shape, its units
/// @param turn   rad
/// @return  in m
Tessellation tessellate_shape(const ShapeInput& input, const std::vector<FaceGeometry>& faces,
                              const std::vector<EdgeGeometry>& edges, double chord, double turn);

}  // namespace isopatch::geometry
