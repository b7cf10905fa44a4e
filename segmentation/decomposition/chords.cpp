#include "segmentation/decomposition/chords.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace isopatch::segmentation {

using geometry::CellComplex;
using geometry::CellFaceUse;
using geometry::EdgeUse;

namespace {

/// The edges inside a side that is several faces, and the vertices on its outline.
struct InsideOfSide {
  std::set<VertexId> outline;
  std::map<VertexId, std::vector<EdgeUse>> edges;  ///< by the vertex that they leave
};

InsideOfSide inside_of(const CellComplex& complex, const std::vector<CellFaceUse>& side) {
  std::map<EdgeId, int> uses;
  for (const CellFaceUse& face : side)
    for (const EdgeUse& use : complex.face(face.face).loop) ++uses[use.edge];
  InsideOfSide result;
  for (const auto& [edge, count] : uses) {
    const VertexId start = complex.edge(edge).start, end = complex.edge(edge).end;
    if (count == 1) {
      result.outline.insert({start, end});
    } else {
      result.edges[start].push_back({edge, false});
      result.edges[end].push_back({edge, true});
    }
  }
  return result;
}

/// The direction of an edge at a share of its way.
Eigen::Vector3d direction(const CellShapes& shapes, EdgeUse use, double share) {
  const Eigen::Vector3d d = shapes.tangent(use.edge, use.reversed ? 1 - share : share).normalized();
  return use.reversed ? Eigen::Vector3d(-d) : d;
}

/// How far the edges inside a side go straight on from one of them.
VertexId end_of(const CellShapes& shapes, const InsideOfSide& inside, EdgeUse use) {
  const CellComplex& complex = shapes.complex();
  for (std::size_t steps = 0; !inside.outline.contains(complex.to(use)) && steps < 100; ++steps) {
    const Eigen::Vector3d ahead = direction(shapes, use, 1);
    const std::vector<EdgeUse>& next = inside.edges.at(complex.to(use));
    const auto straight = [&](const EdgeUse& edge) { return direction(shapes, edge, 0).dot(ahead); };
    const auto best = std::max_element(next.begin(), next.end(), [&](const EdgeUse& a, const EdgeUse& b) {
      return straight(a) < straight(b);
    });
    if (straight(*best) < 1 - 1e-6) break;
    use = *best;
  }
  return complex.to(use);
}

}  // namespace

std::vector<Chord> chords_of(const CellShapes& shapes, const CellSides& sides) {
  std::vector<Chord> result;
  for (std::size_t s = 0; s < sides.faces.size(); ++s) {
    if (sides.faces[s].size() < 2) continue;
    const InsideOfSide inside = inside_of(shapes.complex(), sides.faces[s]);
    for (const auto& [vertex, out] : inside.edges) {
      if (!inside.outline.contains(vertex)) continue;
      for (const EdgeUse& use : out) {
        const VertexId end = end_of(shapes, inside, use);
        const bool across = inside.outline.contains(end);
        if (!across || vertex < end) result.push_back({static_cast<int>(s), vertex, end, use.edge, across});
      }
    }
  }
  std::stable_partition(result.begin(), result.end(), [](const Chord& chord) { return chord.across; });
  return result;
}

std::optional<LoopPlace> place_of(const CellComplex& complex, const CellSides& sides, VertexId vertex) {
  for (std::size_t v = 0; v < sides.vertices.size(); ++v)
    if (sides.vertices[v] == vertex) return LoopPlace::at(VertexId(static_cast<int>(v)));
  for (std::size_t e = 0; e < sides.edges.size(); ++e)
    for (const EdgeUse& use : sides.edges[e])
      if (complex.to(use) == vertex) return LoopPlace::inside(EdgeId(static_cast<int>(e)));
  return std::nullopt;
}

}  // namespace isopatch::segmentation
