#include "geometry/brep/opencascade/internal/face_bodies.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <map>
#include <set>

#include "geometry/base/union_find.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

using Numbers = std::vector<std::size_t>;

/// The faces at each edge that has a length; one twice at a seam.
std::vector<Numbers> faces_at_edges(const std::vector<TopoDS_Face>& faces,
                                    std::vector<Numbers>& edges_of_faces) {
  TopTools_IndexedMapOfShape edges;
  std::vector<Numbers> result;
  edges_of_faces.assign(faces.size(), {});
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (TopExp_Explorer it(faces[f], TopAbs_EDGE); it.More(); it.Next()) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) continue;
      const auto id = static_cast<std::size_t>(edges.Add(it.Current()) - 1);
      if (id == result.size()) result.emplace_back();
      result[id].push_back(f);
      edges_of_faces[f].push_back(id);
    }
  return result;
}

/// Pairs of faces with the same outline at edges of four faces: where two bodies touch.
std::vector<std::array<std::size_t, 2>> touching_pairs(const std::vector<Numbers>& edges_of_faces,
                                                       const std::vector<Numbers>& faces_at) {
  std::map<Numbers, Numbers> with_outline;
  for (std::size_t f = 0; f < edges_of_faces.size(); ++f) {
    Numbers outline = edges_of_faces[f];
    std::sort(outline.begin(), outline.end());
    const bool between = !outline.empty() && std::any_of(outline.begin(), outline.end(), [&](std::size_t e) {
      return faces_at[e].size() > 2;
    });
    if (between) with_outline[outline].push_back(f);
  }
  std::vector<std::array<std::size_t, 2>> pairs;
  for (const auto& entry : with_outline)
    if (entry.second.size() == 2) pairs.push_back({entry.second[0], entry.second[1]});
  return pairs;
}

/// Whether an edge has two faces of every set around it: bodies that meet there.
bool two_of_each(const Numbers& faces, UnionFind& shells) {
  std::map<int, int> count;
  for (const std::size_t f : faces) ++count[shells.find(static_cast<int>(f))];
  return std::all_of(count.begin(), count.end(), [](const auto& entry) { return entry.second == 2; });
}

/// Shells: faces joined by edges of two; then each of two touching faces goes to one of the shells around it.
std::vector<Numbers> shells_of(const std::vector<TopoDS_Face>& faces) {
  std::vector<Numbers> edges_of_faces;
  const auto faces_at = faces_at_edges(faces, edges_of_faces);
  const auto pairs = touching_pairs(edges_of_faces, faces_at);
  std::set<std::size_t> paired;
  for (const auto& pair : pairs) paired.insert(pair.begin(), pair.end());
  UnionFind sets(static_cast<int>(faces.size()));
  const auto join = [&](std::size_t a, std::size_t b) {
    sets.unite(static_cast<int>(a), static_cast<int>(b));
  };
  const auto root = [&](std::size_t f) { return static_cast<std::size_t>(sets.find(static_cast<int>(f))); };
  const auto is_free = [&](std::size_t f) { return !paired.contains(f); };
  for (const Numbers& at : faces_at)
    if (at.size() == 2 && is_free(at[0]) && is_free(at[1])) join(at[0], at[1]);
  for (const Numbers& at : faces_at)
    if (at.size() > 2 && std::all_of(at.begin(), at.end(), is_free) && !two_of_each(at, sets))
      for (std::size_t i = 1; i < at.size(); ++i) join(at[0], at[i]);
  for (const auto& pair : pairs) {
    std::set<std::size_t> around;
    for (const std::size_t edge : edges_of_faces[pair[0]])
      for (const std::size_t f : faces_at[edge])
        if (!paired.contains(f)) around.insert(root(f));
    if (around.size() == 2) {
      join(*around.begin(), pair[0]);
      join(*around.rbegin(), pair[1]);
    } else if (!around.empty()) {  // no two bodies: one that touches itself, for the checks to find
      for (const std::size_t f : pair) join(*around.begin(), f);
    }
  }
  std::map<std::size_t, Numbers> by_root;
  for (std::size_t f = 0; f < faces.size(); ++f) by_root[root(f)].push_back(f);
  std::vector<Numbers> shells;
  for (auto& entry : by_root) shells.push_back(std::move(entry.second));
  std::sort(shells.begin(), shells.end());  // by their first faces
  return shells;
}

std::vector<TopoDS_Face> chosen(const std::vector<TopoDS_Face>& faces, const Numbers& numbers) {
  std::vector<TopoDS_Face> result;
  for (const std::size_t f : numbers) result.push_back(faces[f]);
  return result;
}

Bnd_Box box_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box;
}

bool surrounds(const Bnd_Box& outer, const Bnd_Box& inner) {
  return !outer.IsOut(inner.CornerMin()) && !outer.IsOut(inner.CornerMax());
}

/// How the shells lie in one another.
std::vector<FaceBody> nested(const std::vector<TopoDS_Face>& faces, std::vector<Numbers> shells) {
  std::vector<ShapeInput> solids;
  std::vector<Bnd_Box> boxes;
  for (const Numbers& shell : shells) {
    solids.push_back(oriented_solid(chosen(faces, shell), 1));
    boxes.push_back(box_of(solids.back().shape));
  }
  const auto is_closed = [&](std::size_t i) { return solids[i].shape.ShapeType() == TopAbs_SOLID; };
  const auto count = shells.size();
  std::vector<std::vector<bool>> inside(count, std::vector<bool>(count, false));
  Numbers depth(count, 0);
  for (std::size_t o = 0; o < count; ++o)
    for (std::size_t i = 0; i < count; ++i) {
      if (o == i || !is_closed(o) || !is_closed(i) || !surrounds(boxes[o], boxes[i])) continue;
      const TopoDS_Shape vertex = TopExp_Explorer(solids[i].shape, TopAbs_VERTEX).Current();
      BRepClass3d_SolidClassifier classifier(solids[o].shape, BRep_Tool::Pnt(TopoDS::Vertex(vertex)), 1e-7);
      inside[o][i] = classifier.State() == TopAbs_IN;
      depth[i] += inside[o][i];
    }
  std::vector<FaceBody> result;
  std::vector<std::size_t> body_of(count);
  for (std::size_t i = 0; i < count; ++i)
    if (depth[i] % 2 == 0) {
      body_of[i] = result.size();
      result.push_back({shells[i]});
    }
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t o = 0; depth[i] % 2 == 1 && o < count; ++o)
      if (inside[o][i] && depth[o] + 1 == depth[i]) result[body_of[o]].push_back(shells[i]);
  return result;
}

}  // namespace

std::vector<FaceBody> face_bodies(const std::vector<TopoDS_Face>& faces) {
  std::vector<Numbers> shells = shells_of(faces);
  if (shells.size() < 2) return {{shells.begin(), shells.end()}};
  return nested(faces, std::move(shells));
}

ShapeInput oriented_body(const std::vector<TopoDS_Face>& faces, const FaceBody& body, double metres) {
  ShapeInput result = oriented_solid(chosen(faces, body.front()), metres);
  if (result.shape.ShapeType() != TopAbs_SOLID) return result;
  const BRep_Builder builder;
  for (std::size_t i = 1; i < body.size(); ++i) {
    // A cavity's outward side looks into it.
    const TopoDS_Shape shell =
        TopExp_Explorer(oriented_solid(chosen(faces, body[i]), metres).shape, TopAbs_SHELL)
            .Current()
            .Reversed();
    builder.Add(result.shape, shell);
    for (TopExp_Explorer it(shell, TopAbs_FACE); it.More(); it.Next())
      result.faces.push_back(TopoDS::Face(it.Current()));
  }
  return result;
}

}  // namespace isopatch::geometry
