#include <BRepAlgoAPI_Defeaturing.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

bool is_among(const std::vector<FaceId>& faces, std::size_t face) {
  return std::find(faces.begin(), faces.end(), FaceId(static_cast<int>(face))) != faces.end();
}

/// A face without the outlines that are made of given edges.
/// @return  nothing if others have some of them too, or none would be left
std::optional<TopoDS_Face> without_outlines(const TopoDS_Face& face,
                                            const TopTools_IndexedMapOfShape& edges) {
  const BRep_Builder builder;
  TopoDS_Shape made = face.Oriented(TopAbs_FORWARD).EmptyCopied();
  bool changed = false, any = false;
  for (TopoDS_Iterator wire(face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next()) {
    int count = 0, gone = 0;
    for (TopExp_Explorer edge(wire.Value(), TopAbs_EDGE); edge.More(); edge.Next(), ++count)
      gone += edges.Contains(edge.Current()) ? 1 : 0;
    if (gone != 0 && gone != count) return std::nullopt;
    changed = changed || gone != 0;
    if (gone != 0) continue;
    builder.Add(made, wire.Value());
    any = true;
  }
  if (!changed) return face;
  if (!any) return std::nullopt;
  return TopoDS::Face(made.Oriented(face.Orientation()));
}

/// Where what is removed meets the rest in whole outlines, as bores and pockets inside of faces do, these go
/// and nothing need be extended. The library refuses some of these: through two extruded splines.
std::optional<KernelSolid> without_what_is_inside(const ShapeKernel& source,
                                                  const std::vector<FaceId>& faces) {
  const ShapeInput& given = source.input();
  TopTools_IndexedMapOfShape edges;
  for (const FaceId face : faces)
    TopExp::MapShapes(given.faces[static_cast<std::size_t>(face.value)], TopAbs_EDGE, edges);
  std::vector<TopoDS_Face> kept;
  std::vector<std::string> names;
  std::vector<std::optional<Colour>> colours;
  for (std::size_t f = 0; f < given.faces.size(); ++f) {
    if (is_among(faces, f)) continue;
    const std::optional<TopoDS_Face> left = without_outlines(given.faces[f], edges);
    if (!left) return std::nullopt;
    kept.push_back(*left);
    names.push_back(source.tables().faces[f].name);
    colours.push_back(source.tables().faces[f].colour);
  }
  ShapeInput input = oriented_solid(std::move(kept), given.metres);
  input.names = std::move(names);
  input.colours = std::move(colours);
  return KernelSolid{std::make_shared<ShapeKernel>(std::move(input)), "", 0};
}

}  // namespace

KernelSolid solid_without_faces(const ShapeKernel& source, const std::vector<FaceId>& faces) {
  if (std::optional<KernelSolid> made = without_what_is_inside(source, faces)) return std::move(*made);
  const ShapeInput& given = source.input();
  BRepAlgoAPI_Defeaturing removal;
  removal.SetShape(given.shape);
  for (const FaceId face : faces) removal.AddFaceToRemove(given.faces[static_cast<std::size_t>(face.value)]);
  removal.SetRunParallel(false);
  removal.SetToFillHistory(true);
  removal.Build();
  if (!removal.IsDone() || removal.HasErrors())
    throw Error(ErrorCode::unsupported, "the faces around what is to be removed do not meet without it");
  TopTools_IndexedMapOfShape left;
  for (TopExp_Explorer it(removal.Shape(), TopAbs_FACE); it.More(); it.Next()) left.Add(it.Current());
  std::vector<TopoDS_Face> kept;
  std::vector<std::string> names;
  std::vector<std::optional<Colour>> colours;
  for (std::size_t f = 0; f < given.faces.size(); ++f) {
    if (is_among(faces, f)) continue;
    TopTools_ListOfShape images = removal.Modified(given.faces[f]);
    if (images.IsEmpty() && !removal.IsDeleted(given.faces[f])) images.Append(given.faces[f]);
    for (const TopoDS_Shape& image : images) {
      const int number = left.FindIndex(image);
      if (number == 0) continue;
      kept.push_back(TopoDS::Face(left(number)));
      names.push_back(source.tables().faces[f].name);
      colours.push_back(source.tables().faces[f].colour);
    }
  }
  if (static_cast<int>(kept.size()) != left.Extent())
    throw Error(ErrorCode::unsupported, "the faces around what is to be removed do not meet without it");
  ShapeInput input = oriented_solid(std::move(kept), given.metres);
  input.names = std::move(names);
  input.colours = std::move(colours);
  return {std::make_shared<ShapeKernel>(std::move(input)), "", 0};
}

}  // namespace isopatch::geometry
