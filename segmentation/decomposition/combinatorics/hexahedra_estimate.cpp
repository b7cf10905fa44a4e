#include "segmentation/decomposition/combinatorics/internal/hexahedra_estimate.hpp"

#include <algorithm>
#include <vector>

namespace isopatch::segmentation {
namespace {

constexpr double share_of_any_cell = 5;

double face_share(int corners) {
  if (corners == 3) return 0.5;
  return corners % 2 == 1 ? 1.1 + 0.4 * (corners - 5) : 0.25 * (corners - 4);
}
double vertex_share(int degree) {
  return 2.4 * std::max(0, degree - 3);
}

// Where a step leaves or reaches a vertex, in halves of turns around it: 2 k along edge k, 2 k + 1 inside
// face k.
int spoke(const CellIncidence& incidence, VertexId vertex, const LoopStep& step) {
  const auto place = [](const auto& list, auto id) {
    return static_cast<int>(std::find(list.begin(), list.end(), id) - list.begin());
  };
  return step.auxiliary() ? 2 * place(incidence.faces_at(vertex), step.face) + 1
                          : 2 * place(incidence.edges_at(vertex), step.edge);
}

// Edges strictly between two spokes, counter-clockwise.
int edges_between(int from, int to, int degree) {
  if (to <= from) to += 2 * degree;
  return (to - 1) / 2 - from / 2;
}

double vertex_change(const CellIncidence& incidence, VertexId vertex, const LoopStep& before,
                     const LoopStep& after) {
  const int degree = static_cast<int>(incidence.edges_at(vertex).size());
  const int in = spoke(incidence, vertex, before), out = spoke(incidence, vertex, after);
  return vertex_share(2 + edges_between(out, in, degree)) + vertex_share(2 + edges_between(in, out, degree)) -
         vertex_share(degree);
}

// Corners of a face from one place to another, both counted, as the face walks.
int corners_from(const CellGraph& graph, const CellIncidence& incidence, FaceId face, const LoopPlace& a,
                 const LoopPlace& b) {
  const CellGraph::Corners& corners = graph.face(face);
  const int n = static_cast<int>(corners.size());
  // In halves of sides: 2 k at corner k, 2 k + 1 inside side k.
  const auto at = [&](const LoopPlace& place) {
    if (!place.auxiliary())
      return 2 * static_cast<int>(std::find(corners.begin(), corners.end(), place.vertex) - corners.begin());
    const std::vector<EdgeId>& sides = incidence.sides(face);
    return 2 * static_cast<int>(std::find(sides.begin(), sides.end(), place.edge) - sides.begin()) + 1;
  };
  return 2 + edges_between(at(a), at(b), n);
}

double face_change(const CellGraph& graph, const CellIncidence& incidence, const LoopPlace& from,
                   const LoopPlace& to, FaceId face) {
  return face_share(corners_from(graph, incidence, face, from, to)) +
         face_share(corners_from(graph, incidence, face, to, from)) -
         face_share(static_cast<int>(graph.face(face).size()));
}

}  // namespace

double estimate_change(const CellGraph& graph, const CellIncidence& incidence, const CuttingLoop& loop) {
  const int length = loop.length();
  double change = share_of_any_cell + 2 * face_share(length);
  for (int k = 0; k < length; ++k) {
    const LoopPlace& place = loop.places[k];
    if (!place.auxiliary())
      change += vertex_change(incidence, place.vertex, loop.steps[(k + length - 1) % length], loop.steps[k]);
    if (loop.steps[k].auxiliary())
      change += face_change(graph, incidence, place, loop.places[(k + 1) % length], loop.steps[k].face);
  }
  return change;
}

double hexahedra_estimate(const CellGraph& graph) {
  std::vector<int> degrees(graph.vertex_count);
  double sum = share_of_any_cell;
  for (const CellGraph::Corners& face : graph.faces) {
    sum += face_share(static_cast<int>(face.size()));
    for (const VertexId vertex : face) ++degrees[vertex.value];
  }
  for (const int degree : degrees) sum += vertex_share(degree);
  return sum;
}

}  // namespace isopatch::segmentation
