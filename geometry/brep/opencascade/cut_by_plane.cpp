#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

/// Larger than the solid wherever it cuts it.
TopoDS_Face face_across(const ShapeKernel& source, const Eigen::Vector3d& point,
                        const Eigen::Vector3d& normal) {
  const double metres = source.input().metres;
  const auto& box = source.tables().box;
  const Eigen::Vector3d middle = (box[0] + box[1]) / 2;
  const Eigen::Vector3d at = (middle - (middle - point).dot(normal) * normal) / metres;
  const double reach = (box[1] - box[0]).norm() / metres;
  return BRepBuilderAPI_MakeFace(gp_Pln(to_point(at), gp_Dir(normal.x(), normal.y(), normal.z())), -reach,
                                 reach, -reach, reach);
}

KernelPart part_of(const ShapeKernel& source, const TopoDS_Shape& solid,
                   const TopTools_DataMapOfShapeInteger& origins) {
  KernelPart result;
  std::vector<TopoDS_Face> faces;
  std::vector<std::string> names;
  std::vector<std::optional<Colour>> colours;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    faces.push_back(TopoDS::Face(it.Current()));
    if (!origins.IsBound(it.Current())) {
      result.origin.push_back(std::nullopt);
      names.emplace_back();
      colours.emplace_back();
      continue;
    }
    const int face = origins.Find(it.Current());
    result.origin.emplace_back(FaceId(face));
    names.push_back(source.tables().faces[static_cast<std::size_t>(face)].name);
    colours.push_back(source.tables().faces[static_cast<std::size_t>(face)].colour);
  }
  ShapeInput input = oriented_solid(std::move(faces), source.input().metres);
  input.names = std::move(names);
  input.colours = std::move(colours);
  result.solid = {std::make_shared<ShapeKernel>(std::move(input)), "", 0};
  return result;
}

}  // namespace

std::vector<KernelPart> parts_cut_by_plane(const ShapeKernel& source, const Eigen::Vector3d& point,
                                           const Eigen::Vector3d& normal) {
  const ShapeInput& given = source.input();
  TopTools_ListOfShape solids, tools;
  solids.Append(given.shape);
  tools.Append(face_across(source, point, normal));
  BRepAlgoAPI_Splitter splitter;
  splitter.SetArguments(solids);
  splitter.SetTools(tools);
  splitter.SetRunParallel(false);
  splitter.SetNonDestructive(true);
  splitter.Build();
  if (!splitter.IsDone() || splitter.HasErrors())
    throw Error(ErrorCode::unsupported, "the CAD library cannot cut the solid by a plane");
  TopTools_DataMapOfShapeInteger origins;
  for (std::size_t f = 0; f < given.faces.size(); ++f) {
    TopTools_ListOfShape images = splitter.Modified(given.faces[f]);
    if (images.IsEmpty()) images.Append(given.faces[f]);
    for (const TopoDS_Shape& image : images) origins.Bind(image, static_cast<int>(f));
  }
  std::vector<KernelPart> result;
  for (TopExp_Explorer it(splitter.Shape(), TopAbs_SOLID); it.More(); it.Next())
    result.push_back(part_of(source, it.Current(), origins));
  return result;
}

}  // namespace isopatch::geometry
