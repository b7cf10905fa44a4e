#include <BRepAlgoAPI_Defeaturing.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {

KernelSolid solid_without_faces(const ShapeKernel& source, const std::vector<FaceId>& faces) {
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
    if (std::find(faces.begin(), faces.end(), FaceId(static_cast<int>(f))) != faces.end()) continue;
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
