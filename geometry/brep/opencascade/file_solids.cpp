#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/exchange.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> result;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    result.push_back(TopoDS::Face(it.Current()));
  return result;
}

bool is_closed(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_at;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_at);
  for (int i = 1; i <= faces_at.Extent(); ++i)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(faces_at.FindKey(i))) && faces_at(i).Extent() < 2) return false;
  return true;
}

double size_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

void describe(ShapeInput& input, const FileShape& file, const std::vector<TopoDS_Face>& originals) {
  for (const TopoDS_Face& face : originals) {
    input.names.push_back(file.name_of ? file.name_of(face) : "");
    input.colours.push_back(file.colour_of ? file.colour_of(face) : std::nullopt);
  }
}

// A solid that needs no mending: turned around if it is inside out.
KernelSolid whole_solid(const TopoDS_Shape& shape, const FileShape& file, double metres) {
  const std::vector<TopoDS_Face> originals = faces_of(shape);
  ShapeInput input;
  TopoDS_Solid solid = TopoDS::Solid(shape.Oriented(TopAbs_FORWARD));
  BRepLib::OrientClosedSolid(solid);
  BRepLib::BuildCurves3d(solid);
  input.shape = solid;
  input.faces = faces_of(solid);
  input.metres = metres;
  describe(input, file, originals);
  return {std::make_shared<ShapeKernel>(std::move(input)), file.name, 0};
}

// What faces make when sewn; open where their gaps are too wide.
KernelSolid sewn_faces(const TopoDS_Shape& shape, const FileShape& file, double metres,
                       const SewOptions& options) {
  const std::vector<TopoDS_Face> originals = faces_of(shape);
  const double tolerance = options.same_point * size_of(shape);
  BRepBuilderAPI_Sewing sewing(tolerance, true, true, true, false);
  for (const TopoDS_Face& face : originals) sewing.Add(face);
  sewing.Perform();
  std::vector<TopoDS_Face> faces, kept;
  for (const TopoDS_Face& face : originals) {
    const TopoDS_Shape now = sewing.IsModified(face) ? sewing.Modified(face) : TopoDS_Shape(face);
    for (const TopoDS_Face& part : faces_of(now)) {
      faces.push_back(part);
      kept.push_back(face);
    }
  }
  double correction = 0;
  for (const TopoDS_Face& face : faces)
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      correction = std::max(correction, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
  ShapeInput input = oriented_solid(std::move(faces), metres);
  describe(input, file, kept);
  return {std::make_shared<ShapeKernel>(std::move(input)), file.name, correction * metres};
}

}  // namespace

std::vector<KernelSolid> solids_of(const std::vector<FileShape>& shapes, double metres,
                                   const SewOptions& options, const std::string& source) {
  std::vector<KernelSolid> result;
  for (const FileShape& file : shapes)
    for (TopExp_Explorer it(file.shape, TopAbs_SOLID); it.More(); it.Next())
      result.push_back(is_closed(it.Current()) ? whole_solid(it.Current(), file, metres)
                                               : sewn_faces(it.Current(), file, metres, options));
  if (!result.empty()) return result;
  for (const FileShape& file : shapes)
    if (TopExp_Explorer(file.shape, TopAbs_FACE).More())
      result.push_back(sewn_faces(file.shape, file, metres, options));
  if (result.empty())
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: there is no solid in the file, nor a face of one", source));
  return result;
}

}  // namespace isopatch::geometry
