#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <fmt/format.h>

#include "geometry/brep/opencascade/internal/exchange.hpp"
#include "geometry/brep/opencascade/internal/face_bodies.hpp"
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

double size_of(const std::vector<TopoDS_Face>& faces) {
  Bnd_Box box;
  for (const TopoDS_Face& face : faces) BRepBndLib::Add(face, box, false);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

/// Faces with what the file says of each.
struct DescribedFaces {
  std::vector<TopoDS_Face> faces;
  std::vector<std::string> names;
  std::vector<std::optional<Colour>> colours;
  std::string body;  ///< name of what they bound

  void add(const TopoDS_Face& face, const FaceWords& words) {
    faces.push_back(face);
    names.push_back(words.name);
    colours.push_back(words.colour);
  }
};

DescribedFaces described(const TopoDS_Shape& shape, const FileShape& file) {
  DescribedFaces result;
  result.body = file.name;
  for (const TopoDS_Face& face : faces_of(shape))
    result.add(face, file.words_of ? file.words_of(face) : FaceWords{});
  return result;
}

/// Takes the words of the faces to a body's, which are some of them, perhaps turned around.
void describe(ShapeInput& input, const DescribedFaces& all) {
  TopTools_IndexedMapOfShape known;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < all.faces.size(); ++i)
    if (static_cast<std::size_t>(known.Add(all.faces[i])) > first.size()) first.push_back(i);
  for (const TopoDS_Face& face : input.faces) {
    const int found = known.FindIndex(face);
    input.names.push_back(found > 0 ? all.names[first[static_cast<std::size_t>(found - 1)]] : "");
    input.colours.push_back(found > 0 ? all.colours[first[static_cast<std::size_t>(found - 1)]]
                                      : std::nullopt);
  }
}

/// The bodies that faces bound which share their edges.
std::vector<KernelSolid> separated(const DescribedFaces& all, double metres, double correction) {
  std::vector<KernelSolid> result;
  for (const FaceBody& body : face_bodies(all.faces)) {
    ShapeInput input = oriented_body(all.faces, body, metres);
    describe(input, all);
    result.push_back({std::make_shared<ShapeKernel>(std::move(input)), all.body, correction});
  }
  return result;
}

/// A solid that needs no mending: turned around if it is inside out.
KernelSolid whole_solid(const TopoDS_Shape& shape, const DescribedFaces& all, double metres) {
  ShapeInput input;
  TopoDS_Solid solid = TopoDS::Solid(shape.Oriented(TopAbs_FORWARD));
  BRepLib::OrientClosedSolid(solid);
  BRepLib::BuildCurves3d(solid);
  input.shape = solid;
  input.faces = faces_of(solid);
  input.metres = metres;
  describe(input, all);
  return {std::make_shared<ShapeKernel>(std::move(input)), all.body, 0};
}

/// Curves in the domains of faces: where cylinders of two bodies touch, sewing joins their seams and leaves
/// one without.
void add_missing_curves(const TopoDS_Face& face) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    double first = 0, last = 0;
    if (!BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull()) continue;
    int uses = 0;
    for (TopExp_Explorer other(face, TopAbs_EDGE); other.More(); other.Next())
      uses += other.Current().IsSame(edge);
    ShapeFix_Edge().FixAddPCurve(edge, face, uses > 1);
  }
}

/// The bodies that faces make when sewn; open where their gaps are too wide.
std::vector<KernelSolid> sewn(const DescribedFaces& all, double metres, const SewOptions& options) {
  BRepBuilderAPI_Sewing sewing(options.same_point * size_of(all.faces), true, true, true, true);
  for (const TopoDS_Face& face : all.faces) sewing.Add(face);
  sewing.Perform();
  DescribedFaces now;
  now.body = all.body;
  double correction = 0;
  for (std::size_t f = 0; f < all.faces.size(); ++f) {
    const TopoDS_Face& face = all.faces[f];
    for (const TopoDS_Face& part :
         faces_of(sewing.IsModified(face) ? sewing.Modified(face) : TopoDS_Shape(face))) {
      add_missing_curves(part);
      now.add(part, {all.names[f], all.colours[f]});
      for (TopExp_Explorer it(part, TopAbs_EDGE); it.More(); it.Next())
        correction = std::max(correction, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
    }
  }
  return separated(now, metres, correction * metres);
}

TopoDS_Shape solid_of(const TopoDS_Shape& shell) {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, TopoDS::Shell(shell));
  return solid;
}

/// The bodies of a solid or a shell of the file: one, if it is in order.
std::vector<KernelSolid> bodies_of(const TopoDS_Shape& shape, const FileShape& file, double metres,
                                   const SewOptions& options) {
  const DescribedFaces all = described(shape, file);
  if (!is_closed(shape)) return sewn(all, metres, options);
  const TopoDS_Shape solid = shape.ShapeType() == TopAbs_SHELL ? solid_of(shape) : shape;
  if (face_bodies(all.faces).size() < 2) return {whole_solid(solid, all, metres)};
  return separated(all, metres, 0);
}

template <class Add>
void add_all(std::vector<KernelSolid>& result, Add add) {
  for (KernelSolid& solid : add()) result.push_back(std::move(solid));
}

}  // namespace

void add_bodies(const std::vector<FileShape>& shapes, double metres, const SewOptions& options,
                KernelFile& result) {
  DescribedFaces loose;
  for (const FileShape& file : shapes) {
    bool any = false;
    for (const auto& [kind, avoid] : {std::pair(TopAbs_SOLID, TopAbs_SHAPE), {TopAbs_SHELL, TopAbs_SOLID}})
      for (TopExp_Explorer it(file.shape, kind, avoid); it.More(); it.Next()) {
        any = true;
        ++result.listed;
        if (!TopExp_Explorer(it.Current(), TopAbs_FACE).More())
          result.lost.push_back({0, fmt::format("body {}{} has no faces", result.listed - 1,
                                                file.name.empty() ? "" : " '" + file.name + "'")});
        else
          add_all(result.bodies, [&] { return bodies_of(it.Current(), file, metres, options); });
      }
    for (TopExp_Explorer it(file.shape, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next()) {
      any = true;
      if (loose.faces.empty()) loose.body = file.name;
      loose.add(TopoDS::Face(it.Current()),
                file.words_of ? file.words_of(TopoDS::Face(it.Current())) : FaceWords{});
    }
    if (!any && !file.shape.IsNull() && TopoDS_Iterator(file.shape).More())
      result.remarks.push_back({0, fmt::format("{} has curves or points only, of which no body comes",
                                               file.name.empty() ? "a part" : "part '" + file.name + "'")});
  }
  if (loose.faces.empty()) return;
  result.loose_faces = loose.faces.size();
  add_all(result.bodies, [&] { return sewn(loose, metres, options); });
}

}  // namespace isopatch::geometry
