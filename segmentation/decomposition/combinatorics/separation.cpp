#include "segmentation/decomposition/combinatorics/internal/separation.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "segmentation/decomposition/combinatorics/contraction.hpp"
#include "segmentation/decomposition/combinatorics/internal/planar_map.hpp"
#include "segmentation/decomposition/combinatorics/refinement.hpp"

namespace isopatch::segmentation {
namespace {

enum class Side : char { unknown, left, right };

// A refined graph with the loop as darts of it, and what lies on which side.
struct DividedGraph {
  PlanarMap map;
  Darts around;
  std::vector<int> loop;
  std::vector<Side> side;  // of each face
};

// Spreads the sides from the loop; false if it does not separate them.
bool find_sides(DividedGraph& divided) {
  const auto& [map, around, loop, unused] = divided;
  std::vector<Side>& side = divided.side;
  side.assign(map.faces(), Side::unknown);
  std::vector<char> on_loop(map.corners.size());
  std::vector<int> open;
  const auto put = [&](int face, Side value) {
    if (side[face] != Side::unknown) return side[face] == value;
    side[face] = value;
    open.push_back(face);
    return true;
  };
  for (const int dart : loop) on_loop[dart] = on_loop[around.twin[dart]] = 1;
  for (const int dart : loop)
    if (!put(around.face[dart], Side::left) || !put(around.face[around.twin[dart]], Side::right))
      return false;
  while (!open.empty()) {
    const int face = open.back();
    open.pop_back();
    for (int dart = map.begin[face]; dart < map.begin[face + 1]; ++dart)
      if (!on_loop[dart] && !put(around.face[around.twin[dart]], side[face])) return false;
  }
  return true;
}

// What lies on one side, and the new face; vertices and edges keep their order.
DerivedGraph part_on(const CellGraph& graph, const DividedGraph& divided, Side of) {
  const auto& [map, around, loop, side] = divided;
  DerivedGraph result;
  std::vector<int> number(map.vertices, -1);
  for (int f = 0; f < map.faces(); ++f) {
    if (side[f] != of) continue;
    result.graph.faces.push_back(graph.faces[f]);
    result.faces.push_back({{FaceId(f)}, false});
    for (const VertexId vertex : graph.faces[f]) number[vertex.value] = 0;
  }
  CellGraph::Corners cut;
  for (const int dart : loop) cut.emplace_back(map.corners[dart]);
  if (of == Side::left) std::reverse(cut.begin(), cut.end());
  result.graph.faces.push_back(std::move(cut));
  result.faces.push_back({{}, true});
  for (int v = 0; v < map.vertices; ++v) {
    if (number[v] < 0) continue;
    number[v] = result.graph.vertex_count++;
    result.vertices.push_back(LoopPlace::at(VertexId(v)));
  }
  for (CellGraph::Corners& face : result.graph.faces)
    for (VertexId& vertex : face) vertex = VertexId(number[vertex.value]);
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
    const CellGraph::Edge& edge = graph.edges[e];
    const int dart = around.between(map, edge.start.value, edge.end.value);
    if (side[around.face[dart]] != of && side[around.face[around.twin[dart]]] != of) continue;
    result.graph.edges.push_back(
        {VertexId(number[edge.start.value]), VertexId(number[edge.end.value]), edge.kind, edge.angle});
    result.edges.push_back({{LoopPlace::at(edge.start), LoopPlace::at(edge.end), EdgeId(e), FaceId()}});
  }
  return result;
}

// Gives the loop's edges their kinds in a piece; those through which a face is extended.
std::vector<EdgeId> set_loop_kinds(DerivedGraph& part, const CuttingLoop& loop, Extension own) {
  std::vector<EdgeId> extended;
  const CellGraph::Corners& cut = part.graph.faces.back();
  const int length = loop.length();
  for (int k = 0; k < length; ++k) {
    // The piece to the left walks the loop backwards.
    const int at = own == Extension::left ? length - 1 - k : k;
    const EdgeId id = *edge_between(
        part.graph, cut[at], cut[own == Extension::left ? (at + length - 1) % length : (at + 1) % length]);
    CellGraph::Edge& edge = part.graph.edges[id.value];
    const Extension extension = loop.steps[k].extension;
    edge.kind = EdgeKind::convex;
    if (extension == own) {
      edge.kind = EdgeKind::flat;
      extended.push_back(id);
    } else if (edge.angle) {
      edge.angle = extension == Extension::none ? *edge.angle / 2 : *edge.angle - Angle::degrees(180);
    }
  }
  return extended;
}

std::optional<DerivedGraph> finished_part(const RefinedAlongLoop& refined, const DividedGraph& divided,
                                          const CuttingLoop& loop, Extension own) {
  DerivedGraph part =
      part_on(refined.derived.graph, divided, own == Extension::left ? Side::left : Side::right);
  const std::vector<EdgeId> extended = set_loop_kinds(part, loop, own);
  if (extended.empty()) return composed(refined.derived, part);
  const auto joined = contracted(part.graph, extended);
  if (!joined) return std::nullopt;
  return composed(refined.derived, composed(part, *joined));
}

std::string loop_fault(const CuttingLoop& loop) {
  if (loop.length() < 3 || loop.steps.size() != loop.places.size())
    return "a loop needs three places or more, and as many steps";
  std::vector<LoopPlace> sorted = loop.places;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    return "the loop passes a place twice";
  for (const LoopStep& step : loop.steps)
    if (step.auxiliary() && step.extension != Extension::none) return "a step across a face extends another";
  return {};
}

std::string divide(const RefinedAlongLoop& refined, DividedGraph& divided) {
  divided.map = planar_map(refined.derived.graph);
  divided.around = darts(divided.map);
  if (!is_sphere(divided.map, divided.around))
    return "the cell bounds no ball, or the loop crosses a face beside an edge";
  const std::size_t length = refined.loop.size();
  for (std::size_t k = 0; k < length; ++k) {
    divided.loop.push_back(
        divided.around.between(divided.map, refined.loop[k].value, refined.loop[(k + 1) % length].value));
    if (divided.loop.back() < 0) return "a step of the loop runs along an edge that does not join its places";
  }
  if (!find_sides(divided)) return "the loop has one face on both sides";
  // A solid has four faces, one of which is new.
  for (const Side side : {Side::left, Side::right})
    if (std::count(divided.side.begin(), divided.side.end(), side) < 3)
      return "fewer than three faces lie on one side";
  return {};
}

}  // namespace

Separation separate(const CellGraph& graph, const CuttingLoop& loop) {
  Separation result;
  result.fault = loop_fault(loop);
  if (!result.fault.empty()) return result;
  const auto refined = refined_along(graph, loop);
  if (!refined) {
    result.fault = "a step crosses a face between places that are no corners of one part of it";
    return result;
  }
  DividedGraph divided;
  result.fault = divide(*refined, divided);
  if (!result.fault.empty()) return result;
  auto left = finished_part(*refined, divided, loop, Extension::left);
  auto right = finished_part(*refined, divided, loop, Extension::right);
  if (left && right)
    result.pieces = CutPieces{std::move(*left), std::move(*right)};
  else
    result.fault = "a face and the new face that extends it are no disc together";
  return result;
}

}  // namespace isopatch::segmentation
