#pragma once

#include "geometry/brep/opencascade/internal/shape_input.hpp"

namespace isopatch::geometry {

/// Faces, edges and vertices of a shape with their curves and surfaces.
struct ShapeTables {
  BrepTables tables;
  std::vector<FaceGeometry> faces;
  std::vector<EdgeGeometry> edges;
};

/// Numbers them in the order in which the loops of the faces meet them.
/// @throws Error not_manifold  an edge without length or without a curve
ShapeTables shape_tables(const ShapeInput& input);

}  // namespace isopatch::geometry
