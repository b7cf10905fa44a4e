#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

std::optional<EdgeId> edge_along(const CellIncidence& incidence, const LoopPlace& a, const LoopPlace& b) {
  if (a.auxiliary() || b.auxiliary()) return std::nullopt;
  return incidence.edge_between(a.vertex, b.vertex);
}

Extension turned(Extension extension) {
  if (extension == Extension::none) return extension;
  return extension == Extension::left ? Extension::right : Extension::left;
}

// The other way round, from the same place on.
CuttingLoop reversed(CuttingLoop loop) {
  std::reverse(loop.places.begin() + 1, loop.places.end());
  std::reverse(loop.steps.begin(), loop.steps.end());
  for (LoopStep& step : loop.steps) step.extension = turned(step.extension);
  return loop;
}

}  // namespace

bool CuttingLoop::extends() const {
  return std::any_of(steps.begin(), steps.end(),
                     [](const LoopStep& step) { return step.extension != Extension::none; });
}

int CuttingLoop::auxiliary_vertices() const {
  return static_cast<int>(
      std::count_if(places.begin(), places.end(), [](const LoopPlace& place) { return place.auxiliary(); }));
}

int CuttingLoop::auxiliary_edges() const {
  return static_cast<int>(
      std::count_if(steps.begin(), steps.end(), [](const LoopStep& step) { return step.auxiliary(); }));
}

CuttingLoop normal_form(const CuttingLoop& loop) {
  if (loop.places.empty() || loop.steps.size() != loop.places.size()) return loop;
  CuttingLoop result = loop;
  const auto lowest = std::min_element(loop.places.begin(), loop.places.end()) - loop.places.begin();
  std::rotate(result.places.begin(), result.places.begin() + lowest, result.places.end());
  std::rotate(result.steps.begin(), result.steps.begin() + lowest, result.steps.end());
  return result.places.back() < result.places[1 % result.places.size()] ? reversed(std::move(result))
                                                                        : result;
}

std::vector<FaceId> faces_at(const CellIncidence& incidence, const LoopPlace& place) {
  if (!place.auxiliary()) return incidence.faces_at(place.vertex);
  return {incidence.left(place.edge), incidence.right(place.edge)};
}

std::string words(const LoopPlace& place) {
  return place.auxiliary() ? fmt::format("a vertex on edge {}", place.edge.value)
                           : fmt::format("vertex {}", place.vertex.value);
}

CuttingLoop loop_through(const CellGraph& graph, const CellIncidence& incidence,
                         const std::vector<LoopPlace>& places) {
  check_places(graph, places);
  CuttingLoop loop{places, {}};
  for (std::size_t k = 0; k < places.size(); ++k) {
    const LoopPlace &from = places[k], &to = places[(k + 1) % places.size()];
    if (const auto edge = edge_along(incidence, from, to)) {
      loop.steps.push_back(LoopStep::along(*edge));
      continue;
    }
    std::vector<FaceId> common;
    for (const FaceId face : faces_at(incidence, from))
      for (const FaceId other : faces_at(incidence, to))
        if (face == other) common.push_back(face);
    if (common.size() != 1)
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("a loop goes from {} to {}, which share {} faces and no edge; it needs exactly one",
                      words(from), words(to), common.size()));
    loop.steps.push_back(LoopStep::across(common.front()));
  }
  return loop;
}

void check_places(const CellGraph& graph, const std::vector<LoopPlace>& places) {
  const int edge_count = static_cast<int>(graph.edges.size());
  for (const LoopPlace& place : places)
    if (place.auxiliary() ? place.edge.value >= edge_count
                          : place.vertex.value < 0 || place.vertex.value >= graph.vertex_count)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("a loop passes {}, but the cell has {} vertices and {} edges", words(place),
                              graph.vertex_count, edge_count));
}

}  // namespace isopatch::segmentation
