#include "geometry/brep/opencascade/internal/scaled_shape.hpp"

#include <BRepBuilderAPI_Transform.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Trsf.hxx>

namespace isopatch::geometry {

ScaledShape scaled_shape(const ShapeKernel& kernel, double metres) {
  const ShapeInput& input = kernel.input();
  const double scale = input.metres / metres;
  if (std::abs(scale - 1) < 1e-14) return {input.shape, input.faces};
  gp_Trsf transformation;
  transformation.SetScaleFactor(scale);
  BRepBuilderAPI_Transform transform(input.shape, transformation, true);
  ScaledShape result{transform.Shape(), {}};
  for (const TopoDS_Face& face : input.faces)
    result.faces.push_back(TopoDS::Face(transform.ModifiedShape(face)));
  return result;
}

}  // namespace isopatch::geometry
