#pragma once

#include "geometry/brep/opencascade/internal/shape_kernel.hpp"

namespace isopatch::geometry {

/// A kernel's shape in another unit, and its faces in the order of their ids.
struct ScaledShape {
  TopoDS_Shape shape;
  std::vector<TopoDS_Face> faces;
};

/// @param metres  that the unit measures
ScaledShape scaled_shape(const ShapeKernel& kernel, double metres);

}  // namespace isopatch::geometry
