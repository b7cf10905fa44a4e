#include "segmentation/decomposition/combinatorics/loop_validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "segmentation/decomposition/combinatorics/internal/separation.hpp"

namespace isopatch::segmentation {
namespace {

bool ends_at(const CellGraph::Edge& edge, const LoopPlace& a, const LoopPlace& b) {
  return !a.auxiliary() && !b.auxiliary() &&
         std::minmax(edge.start, edge.end) == std::minmax(a.vertex, b.vertex);
}

std::optional<std::string> step_fault(const CellGraph& graph, const CellIncidence& incidence,
                                      const LoopPlace& from, const LoopPlace& to, const LoopStep& step) {
  const auto between = [&] { return fmt::format("from {} to {}", words(from), words(to)); };
  if (!step.auxiliary()) {
    if (step.edge.value < 0 || step.edge.value >= static_cast<int>(graph.edges.size()) ||
        !ends_at(graph.edge(step.edge), from, to))
      return fmt::format("a step {} runs along edge {}, which does not join them", between(),
                         step.edge.value);
    if (step.extension != Extension::none && graph.edge(step.edge).kind == EdgeKind::convex)
      return fmt::format("a face is extended through edge {}, which is convex", step.edge.value);
    return std::nullopt;
  }
  if (step.extension != Extension::none)
    return fmt::format("a step {} across a face extends another", between());
  for (const LoopPlace& place : {from, to}) {
    const std::vector<FaceId> faces = faces_at(incidence, place);
    if (std::find(faces.begin(), faces.end(), step.face) == faces.end())
      return fmt::format("a step {} crosses face {}, on which {} does not lie", between(), step.face.value,
                         words(place));
  }
  return std::nullopt;
}

std::optional<std::string> shape_fault(const CellGraph& graph, const CellIncidence& incidence,
                                       const CuttingLoop& loop) {
  if (loop.length() < 3) return fmt::format("a loop of {} places; three are the fewest", loop.length());
  if (loop.steps.size() != loop.places.size()) return "a loop has as many steps as places";
  std::vector<LoopPlace> sorted = loop.places;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    return fmt::format("the loop passes {} twice", words(*twice));
  for (std::size_t k = 0; k < loop.steps.size(); ++k)
    if (auto fault = step_fault(graph, incidence, loop.places[k], loop.places[(k + 1) % loop.places.size()],
                                loop.steps[k]))
      return fault;
  return std::nullopt;
}

// The exact rule for loops without extensions.
std::optional<std::string> face_fault(const CellIncidence& incidence, const CuttingLoop& loop) {
  std::map<FaceId, std::vector<int>> on;
  for (int k = 0; k < loop.length(); ++k)
    for (const FaceId face : faces_at(incidence, loop.places[k])) on[face].push_back(k);
  for (const auto& [face, at] : on) {
    if (at.size() > 2)
      return fmt::format("face {} has {} places of the loop, two are the most", face.value, at.size());
    if (at.size() == 2 && at[1] - at[0] != 1 && at[1] - at[0] != loop.length() - 1)
      return fmt::format("face {} has {} and {}, which do not follow each other in the loop", face.value,
                         words(loop.places[at[0]]), words(loop.places[at[1]]));
  }
  return std::nullopt;
}

std::optional<std::string> piece_fault(const CellGraph& graph, const CuttingLoop& loop) {
  const Separation result = separate(graph, loop);
  if (!result.pieces) return result.fault;
  if (!is_three_connected(result.pieces->left.graph)) return "the piece to the left would not be 3-connected";
  if (!is_three_connected(result.pieces->right.graph))
    return "the piece to the right would not be 3-connected";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> why_invalid(const CellGraph& graph, const CellIncidence& incidence,
                                       const CuttingLoop& loop) {
  check_places(graph, loop.places);
  if (auto fault = shape_fault(graph, incidence, loop)) return fault;
  return loop.extends() ? piece_fault(graph, loop) : face_fault(incidence, loop);
}

}  // namespace isopatch::segmentation
