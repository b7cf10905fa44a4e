#include "segmentation/decomposition/prepare.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"
#include "geometry/brep/cell_solids.hpp"
#include "segmentation/decomposition/artificial_edges.hpp"
#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CellFace;
using geometry::CurveKind;
using geometry::EdgeUse;

bool in_one_plane(const Brep& source, FaceId a, FaceId b) {
  const auto one = source.carrier(a), two = source.carrier(b);
  if (!one || !two || one->kind != geometry::SurfaceKind::plane || two->kind != one->kind) return false;
  const double off = std::abs((two->origin - one->origin).dot(one->axis));
  return one->axis.cross(two->axis).norm() < 1e-7 && off < 1e-7 * source.size() &&
         source.outward_normal(a, source.domain(a).low).dot(source.outward_normal(b, source.domain(b).low)) >
             0;
}

bool belong_together(const Brep& source, FaceId a, FaceId b) {
  return source.face(a).name == source.face(b).name && source.face(a).colour == source.face(b).colour &&
         in_one_plane(source, a, b);
}

/// Faces that are one, by the lowest of them.
UnionFind merged_faces(const Brep& source) {
  UnionFind groups(static_cast<int>(source.faces().size()));
  for (const geometry::BrepEdge& edge : source.edges())
    if (edge.faces.size() == 2 && edge.faces[0] != edge.faces[1] &&
        belong_together(source, edge.faces[0], edge.faces[1]))
      groups.unite(edge.faces[0].value, edge.faces[1].value);
  return groups;
}

/// The one closed walk that edge uses make; nothing if they make several or touch themselves.
std::optional<std::vector<EdgeUse>> one_loop(const CellComplex& complex, const std::vector<EdgeUse>& uses) {
  std::map<VertexId, EdgeUse> from;
  for (const EdgeUse& use : uses)
    if (!from.emplace(complex.from(use), use).second) return std::nullopt;
  std::vector<EdgeUse> loop;
  VertexId at = complex.from(uses.front());
  do {
    loop.push_back(from.at(at));
    at = complex.to(loop.back());
  } while (at != complex.from(uses.front()));
  if (loop.size() != uses.size()) return std::nullopt;
  return loop;
}

/// The outline of a group of faces: what two of them share drops out.
std::optional<std::vector<EdgeUse>> outline_of(const CellComplex& complex, const std::vector<FaceId>& faces) {
  std::map<EdgeId, std::vector<EdgeUse>> uses;
  std::vector<EdgeUse> left;
  for (const FaceId face : faces)
    for (const EdgeUse& use : complex.face(face).loop) uses[use.edge].push_back(use);
  for (const auto& [edge, of] : uses)
    if (of.size() == 1) left.push_back(of.front());
  return one_loop(complex, left);
}

/// Takes vertices out that join two straight edges in one line, with no third edge.
class StraightEdges {
 public:
  StraightEdges(const Brep& source, CellComplex& complex) : source_(source), complex_(complex) {}

  void join() {
    std::map<VertexId, std::set<EdgeId>> at;
    for (const CellFace& face : complex_.faces)
      for (const EdgeUse& use : face.loop) {
        at[complex_.from(use)].insert(use.edge);
        at[complex_.to(use)].insert(use.edge);
      }
    for (const auto& [vertex, edges] : at)
      if (edges.size() == 2) join_at(vertex, *edges.begin(), *edges.rbegin(), at);
  }

 private:
  bool is_straight(EdgeId id) const {
    const auto* source = std::get_if<EdgeId>(&complex_.curve(complex_.edge(id).curve).shape);
    return source == nullptr || source_.edge(*source).kind == CurveKind::line;
  }

  VertexId other_end(EdgeId id, VertexId vertex) const {
    const geometry::CellEdge& edge = complex_.edge(id);
    return edge.start == vertex ? edge.end : edge.start;
  }

  void join_at(VertexId vertex, EdgeId first, EdgeId second, std::map<VertexId, std::set<EdgeId>>& at) {
    const VertexId from = other_end(first, vertex), to = other_end(second, vertex);
    const Eigen::Vector3d a = complex_.vertex(vertex) - complex_.vertex(from),
                          b = complex_.vertex(to) - complex_.vertex(vertex);
    if (!is_straight(first) || !is_straight(second) || from == to ||
        !(a.cross(b).norm() < 1e-7 * a.norm() * b.norm() && a.dot(b) > 0))
      return;
    const EdgeId joined = complex_.add_straight_edge(from, to);
    for (CellFace& face : complex_.faces) replace(face, first, second, joined, from);
    for (const VertexId end : {from, to}) {
      at[end].erase(first);
      at[end].erase(second);
      at[end].insert(joined);
    }
  }

  void replace(CellFace& face, EdgeId first, EdgeId second, EdgeId joined, VertexId from) {
    const auto found = std::find_if(face.loop.begin(), face.loop.end(),
                                    [&](const EdgeUse& use) { return use.edge == first; });
    if (found == face.loop.end()) return;
    *found = {joined, complex_.from(*found) != from};
    std::erase_if(face.loop, [&](const EdgeUse& use) { return use.edge == second; });
  }

  const Brep& source_;
  CellComplex& complex_;
};

/// Faces that belong together, two or more each.
std::vector<std::vector<FaceId>> groups_of_faces(const Brep& source) {
  UnionFind groups = merged_faces(source);
  std::map<int, std::vector<FaceId>> members;
  for (int f = 0; f < static_cast<int>(source.faces().size()); ++f) members[groups.find(f)].emplace_back(f);
  std::vector<std::vector<FaceId>> result;
  for (auto& [lowest, faces] : members)
    if (faces.size() > 1) result.push_back(std::move(faces));
  return result;
}

/// The solid as one cell in which the faces of each group are one face.
CellComplex merged(const Brep& source, const std::vector<std::vector<FaceId>>& groups) {
  CellComplex complex = geometry::one_cell(source);
  std::map<int, std::vector<FaceId>> members;
  for (int f = 0; f < static_cast<int>(complex.faces.size()); ++f) members[f] = {FaceId(f)};
  for (const std::vector<FaceId>& group : groups) {
    for (const FaceId face : group) members.erase(face.value);
    members[group.front().value] = group;
  }
  geometry::Cell cell;
  for (const auto& [lowest, faces] : members) {
    auto loop = faces.size() > 1 ? outline_of(complex, faces) : std::nullopt;
    for (const FaceId face : faces) {
      if (loop && face.value != lowest) continue;
      if (loop) complex.faces[static_cast<std::size_t>(face.value)].loop = *loop;
      cell.faces.push_back({face, false, face.value});
    }
    if (loop)
      for (const FaceId face : faces)
        if (face.value != lowest) complex.faces[static_cast<std::size_t>(face.value)].loop.clear();
  }
  complex.cells = {std::move(cell)};
  StraightEdges(source, complex).join();
  return complex;
}

bool is_three_connected(const Brep& source, const CellComplex& complex) {
  try {
    return segmentation::is_three_connected(
        cell_sides(CellShapes(source, complex), geometry::CellId(0)).graph);
  } catch (const Error&) {
    return false;
  }
}

/// With artificial edges, if that makes it 3-connected; else the other.
CellComplex divided_or(const Brep& source, const CellComplex& complex, CellComplex other) {
  try {
    if (auto divided = with_artificial_edges(source, complex)) return std::move(*divided);
  } catch (const Error&) {  // it has no graph, which is said by name where that is asked for
  }
  return other;
}

}  // namespace

CellComplex prepared(const Brep& source) {
  const std::vector<std::vector<FaceId>> groups = groups_of_faces(source);
  CellComplex all = merged(source, groups);
  if (is_three_connected(source, all)) return all;
  CellComplex as_given = geometry::one_cell(source);
  if (is_three_connected(source, as_given)) return as_given;
  return divided_or(source, all, std::move(as_given));
}

std::vector<std::vector<FaceId>> faces_made_one(const Brep& source, const CellComplex& made) {
  std::set<FaceId> left;
  for (const geometry::Cell& cell : made.cells)
    for (const geometry::CellFaceUse& use : cell.faces)
      if (const auto origin = made.face(use.face).origin) left.insert(*origin);
  std::vector<std::vector<FaceId>> result = groups_of_faces(source);
  std::erase_if(result, [&](const std::vector<FaceId>& group) {
    return std::all_of(group.begin(), group.end(), [&](FaceId face) { return left.contains(face); });
  });
  return result;
}

}  // namespace isopatch::segmentation
