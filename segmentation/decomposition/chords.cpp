#include "segmentation/decomposition/chords.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "segmentation/decomposition/cutting/side_inside.hpp"

namespace isopatch::segmentation {

using geometry::CellComplex;
using geometry::EdgeUse;

namespace {

/// The edges inside a side by the vertex that they leave.
std::map<VertexId, std::vector<EdgeUse>> leaving(const CellComplex& complex, const SideInside& inside) {
  std::map<VertexId, std::vector<EdgeUse>> result;
  for (const EdgeId edge : inside.edges) {
    result[complex.edge(edge).start].push_back({edge, false});
    result[complex.edge(edge).end].push_back({edge, true});
  }
  return result;
}

/// The direction of an edge at a share of its way.
Eigen::Vector3d direction(const CellShapes& shapes, EdgeUse use, double share) {
  const Eigen::Vector3d d = shapes.tangent(use.edge, use.reversed ? 1 - share : share).normalized();
  return use.reversed ? Eigen::Vector3d(-d) : d;
}

/// How far the edges inside a side go straight on from one of them.
VertexId end_of(const CellShapes& shapes, const std::set<VertexId>& outline,
                const std::map<VertexId, std::vector<EdgeUse>>& edges, EdgeUse use) {
  const CellComplex& complex = shapes.complex();
  for (std::size_t steps = 0; !outline.contains(complex.to(use)) && steps < 100; ++steps) {
    const Eigen::Vector3d ahead = direction(shapes, use, 1);
    const std::vector<EdgeUse>& next = edges.at(complex.to(use));
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
    const SideInside inside = side_inside(shapes.complex(), sides.faces[s]);
    const auto edges = leaving(shapes.complex(), inside);
    for (const auto& [vertex, out] : edges) {
      if (!inside.outline.contains(vertex)) continue;
      for (const EdgeUse& use : out) {
        const VertexId end = end_of(shapes, inside.outline, edges, use);
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
