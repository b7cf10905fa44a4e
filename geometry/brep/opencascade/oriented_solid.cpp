#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <array>
#include <cmath>

#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

struct EdgeOfFace {
  std::size_t face;
  bool forward;
};

// The faces at each edge, and how they walk it.
std::vector<std::vector<EdgeOfFace>> sides_of_edges(const std::vector<TopoDS_Face>& faces) {
  TopTools_IndexedMapOfShape edges;
  std::vector<std::vector<EdgeOfFace>> sides;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (TopExp_Explorer it(faces[i], TopAbs_EDGE); it.More(); it.Next()) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) continue;
      const auto id = static_cast<std::size_t>(edges.Add(it.Current()) - 1);
      if (id == sides.size()) sides.emplace_back();
      sides[id].push_back({i, it.Current().Orientation() == TopAbs_FORWARD});
    }
  return sides;
}

// Turns faces around until two neighbours walk their common edge in opposite directions, starting from each
// first face. Returns whether every edge has two sides.
bool agree(std::vector<TopoDS_Face>& faces) {
  const auto sides = sides_of_edges(faces);
  std::vector<std::vector<std::array<std::size_t, 2>>> neighbours(
      faces.size());  // face, whether it must differ
  bool closed = true;
  for (const auto& at : sides) {
    closed = closed && at.size() == 2;
    if (at.size() != 2 || at[0].face == at[1].face) continue;
    const std::size_t turned = at[0].forward == at[1].forward;
    neighbours[at[0].face].push_back({at[1].face, turned});
    neighbours[at[1].face].push_back({at[0].face, turned});
  }
  std::vector<int> turned(faces.size(), -1);
  for (std::size_t first = 0; first < faces.size(); ++first) {
    if (turned[first] >= 0) continue;
    std::vector<std::size_t> open = {first};
    turned[first] = 0;
    while (!open.empty()) {
      const std::size_t face = open.back();
      open.pop_back();
      for (const auto& [other, differs] : neighbours[face])
        if (turned[other] < 0) {
          turned[other] = turned[face] ^ static_cast<int>(differs);
          open.push_back(other);
        }
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (turned[i] == 1) faces[i].Reverse();
  return closed;
}

TopoDS_Shell shell_of(const std::vector<TopoDS_Face>& faces, bool closed) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Face& face : faces) builder.Add(shell, face);
  shell.Closed(closed);
  return shell;
}

double volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

}  // namespace

ShapeInput oriented_solid(std::vector<TopoDS_Face> faces, double metres) {
  ShapeInput input;
  input.metres = metres;
  const bool closed = agree(faces);
  TopoDS_Shell shell = shell_of(faces, closed);
  if (volume_of(shell) < 0) {
    for (TopoDS_Face& face : faces) face.Reverse();
    shell = shell_of(faces, closed);
  }
  input.faces = std::move(faces);
  if (!closed) {
    input.shape = shell;
    return input;
  }
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  input.shape = solid;
  return input;
}

double kernel_scale(double size) {
  return size > 0 ? std::exp2(std::round(std::log2(100 / size))) : 1;
}

}  // namespace isopatch::geometry
