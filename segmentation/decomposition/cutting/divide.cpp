#include "segmentation/decomposition/cutting/divide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"

namespace isopatch::segmentation {

using geometry::Cell;
using geometry::CellComplex;
using geometry::CellFace;
using geometry::CellFaceUse;
using geometry::CellId;
using geometry::EdgeUse;

VertexId divide_edge(CellComplex& complex, EdgeId id, double t, const Eigen::Vector3d& point) {
  if (!(t > 0 && t < 1))
    throw Error(ErrorCode::invalid_argument, fmt::format("an edge is divided at {}; the range is (0, 1)", t));
  const VertexId vertex = complex.add_vertex(point);
  geometry::CellEdge& first = complex.edges[static_cast<std::size_t>(id.value)];
  geometry::CellEdge second = first;
  first.high = second.low = first.low + t * (first.high - first.low);
  first.end = second.start = vertex;
  const EdgeId added(static_cast<int>(complex.edges.size()));
  complex.edges.push_back(second);
  for (CellFace& face : complex.faces)
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
      if (face.loop[i].edge != id) continue;
      const bool reversed = face.loop[i].reversed;
      face.loop.insert(face.loop.begin() + static_cast<std::ptrdiff_t>(i + (reversed ? 0 : 1)),
                       EdgeUse{added, reversed});
      ++i;
    }
  return vertex;
}

namespace {

/// Where a loop's walk starts from a vertex.
std::size_t position(const CellComplex& complex, const std::vector<EdgeUse>& loop, VertexId vertex) {
  const auto found =
      std::find_if(loop.begin(), loop.end(), [&](const EdgeUse& use) { return complex.from(use) == vertex; });
  if (found == loop.end())
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("vertex {} is not on the outline of the face that is to be divided", vertex.value));
  return static_cast<std::size_t>(found - loop.begin());
}

/// The walk of a closed loop from one position up to another.
std::vector<EdgeUse> stretch(const std::vector<EdgeUse>& loop, std::size_t from, std::size_t to) {
  std::vector<EdgeUse> result;
  for (std::size_t i = from; i != to; i = (i + 1) % loop.size()) result.push_back(loop[i]);
  return result;
}

}  // namespace

EdgeId divide_face(CellComplex& complex, FaceId id, VertexId from, VertexId to, geometry::CurveId curve) {
  const CellFace whole = complex.face(id);
  const std::size_t start = position(complex, whole.loop, from), end = position(complex, whole.loop, to);
  if (start == end)
    throw Error(ErrorCode::invalid_argument, "a face is divided between two different vertices");
  const EdgeId edge(static_cast<int>(complex.edges.size()));
  complex.edges.push_back({curve, 0, 1, from, to});
  // To the left of the edge lies what the outline walks from its end back to its start.
  CellFace left = whole, right = whole;
  left.loop = stretch(whole.loop, end, start);
  left.loop.push_back({edge, false});
  right.loop = stretch(whole.loop, start, end);
  right.loop.push_back({edge, true});
  complex.faces[static_cast<std::size_t>(id.value)] = std::move(left);
  const FaceId added = complex.add_face(std::move(right));
  for (Cell& cell : complex.cells)
    for (std::size_t i = 0; i < cell.faces.size(); ++i) {
      if (cell.faces[i].face != id) continue;
      CellFaceUse use = cell.faces[i];
      use.face = added;
      cell.faces.push_back(use);
      break;
    }
  return edge;
}

DividedCell divide_cell(CellComplex& complex, CellId id, const std::vector<EdgeUse>& walk,
                        geometry::SurfaceId surface) {
  const std::vector<CellFaceUse> whole = complex.cell(id).faces;
  std::set<EdgeId> across;
  for (const EdgeUse& use : walk) across.insert(use.edge);
  // Faces that are connected without crossing the walk.
  std::map<EdgeId, int> face_at;
  UnionFind parts(static_cast<int>(whole.size()));
  std::set<int> left, right;
  for (std::size_t f = 0; f < whole.size(); ++f)
    for (EdgeUse use : complex.face(whole[f].face).loop) {
      use.reversed = use.reversed != whole[f].reversed;
      if (!across.contains(use.edge)) {
        const auto [other, fresh] = face_at.try_emplace(use.edge, static_cast<int>(f));
        if (!fresh) parts.unite(other->second, static_cast<int>(f));
        continue;
      }
      (std::find(walk.begin(), walk.end(), use) != walk.end() ? left : right).insert(static_cast<int>(f));
    }
  std::set<int> roots;
  for (int f = 0; f < static_cast<int>(whole.size()); ++f) roots.insert(parts.find(f));
  const auto all_in = [&](const std::set<int>& faces) {
    return !faces.empty() && std::all_of(faces.begin(), faces.end(),
                                         [&](int f) { return parts.find(f) == parts.find(*faces.begin()); });
  };
  if (roots.size() != 2 || !all_in(left) || !all_in(right) ||
      parts.find(*left.begin()) == parts.find(*right.begin()))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("a walk of {} edges takes the boundary of a cell into {} parts; it must be two",
                            walk.size(), roots.size()));
  const int kept = parts.find(*left.begin());
  Cell one, two;
  int side = 0;
  for (std::size_t f = 0; f < whole.size(); ++f) {
    (parts.find(static_cast<int>(f)) == kept ? one : two).faces.push_back(whole[f]);
    side = std::max(side, whole[f].side + 1);
  }
  // The cell that is kept walks its other faces along the walk, so the new one against it: its front looks
  // into that cell.
  const FaceId face = complex.add_face({surface, walk});
  one.faces.push_back({face, true, side});
  two.faces.push_back({face, false, side});
  const CellId other(static_cast<int>(complex.cells.size()));
  complex.cells[static_cast<std::size_t>(id.value)] = std::move(one);
  complex.cells.push_back(std::move(two));
  return {face, other};
}

}  // namespace isopatch::segmentation
