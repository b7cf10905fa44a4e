#include <BOPAlgo_Builder.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp_Face.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

TopoDS_Shape pushed(const TopoDS_Face& face, const Eigen::Vector3d& to, const Eigen::Vector3d& along) {
  double low_u = 0, high_u = 0, low_v = 0, high_v = 0;
  const BRepGProp_Face shape(face);
  shape.Bounds(low_u, high_u, low_v, high_v);
  gp_Pnt at;
  gp_Vec normal;
  shape.Normal(low_u, low_v, at, normal);
  const Eigen::Vector3d by = (to - to_eigen(at)).dot(along) * along;
  gp_Trsf push;
  push.SetTranslation(gp_Vec(by.x(), by.y(), by.z()));
  return BRepBuilderAPI_Transform(face, push, true).Shape();
}

bool looks_along(const TopoDS_Face& face, const Eigen::Vector3d& along) {
  double low_u = 0, high_u = 0, low_v = 0, high_v = 0;
  const BRepGProp_Face shape(face);
  shape.Bounds(low_u, high_u, low_v, high_v);
  gp_Pnt at;
  gp_Vec normal;
  shape.Normal(low_u, low_v, at, normal);
  return to_eigen(normal).dot(along) > 0;
}

/// Faces that the same loops bound as one, however many of them cover it.
std::vector<TopoDS_Face> fused(const TopTools_ListOfShape& faces, double fuzzy) {
  BOPAlgo_Builder builder;
  for (const TopoDS_Shape& face : faces) builder.AddArgument(face);
  builder.SetFuzzyValue(fuzzy);
  builder.SetRunParallel(false);
  builder.Perform();
  if (builder.HasErrors())
    throw Error(ErrorCode::unsupported, "outlines cannot be laid over each other by the CAD library");
  TopTools_IndexedMapOfShape found;
  std::vector<TopoDS_Face> result;
  for (TopExp_Explorer it(builder.Shape(), TopAbs_FACE); it.More(); it.Next())
    if (!found.Contains(it.Current())) {
      found.Add(it.Current());
      result.push_back(TopoDS::Face(it.Current()));
    }
  return result;
}

}  // namespace

KernelSolid overlay_of(const ShapeKernel& source, const std::vector<FaceId>& faces,
                       const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const double metres = source.input().metres;
  const auto& box = source.tables().box;
  TopTools_ListOfShape flat;
  for (const FaceId face : faces)
    flat.Append(pushed(source.input().faces[static_cast<std::size_t>(face.value)], origin / metres, direction));
  ShapeInput input;
  input.metres = metres;
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (TopoDS_Face& face : fused(flat, 1e-7 * (box[1] - box[0]).norm() / metres)) {
    if (!looks_along(face, direction)) face.Reverse();
    builder.Add(shell, face);
    input.faces.push_back(face);
  }
  input.shape = shell;
  return {std::make_shared<ShapeKernel>(std::move(input)), "", 0};
}

}  // namespace isopatch::geometry
