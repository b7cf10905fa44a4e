#include "segmentation/decomposition/combinatorics/loop_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/internal/loop_shape.hpp"

namespace isopatch::segmentation {
namespace {

int flat_count(const CellGraph& graph) {
  return static_cast<int>(
      std::count_if(graph.edges.begin(), graph.edges.end(),
                    [](const CellGraph::Edge& edge) { return edge.kind == EdgeKind::flat; }));
}

int off_four(std::size_t corners) {
  return std::abs(static_cast<int>(corners) - 4);
}

// Corners of the part of a face that a piece has, 4 if it has none.
std::size_t part_size(const DerivedGraph& piece, FaceId face) {
  for (std::size_t f = 0; f < piece.faces.size(); ++f)
    if (std::find(piece.faces[f].faces.begin(), piece.faces[f].faces.end(), face) !=
        piece.faces[f].faces.end())
      return piece.graph.faces[f].size();
  return 4;
}

double face_size_term(const CellGraph& graph, const CuttingLoop& loop, const CutPieces& pieces) {
  double sum = 0;
  for (const LoopStep& step : loop.steps)
    if (step.auxiliary())
      sum += std::max(0, off_four(part_size(pieces.left, step.face)) +
                             off_four(part_size(pieces.right, step.face)) -
                             off_four(graph.face(step.face).size()));
  return sum;
}

double t_joint_term(const CellIncidence& incidence, const std::vector<bool>& has_neighbour,
                    const CuttingLoop& loop) {
  if (has_neighbour.empty()) return 0;
  double sum = 0;
  for (const LoopStep& step : loop.steps)
    if (step.auxiliary()) sum += has_neighbour[step.face.value];
  for (const LoopPlace& place : loop.places)
    if (place.auxiliary())
      sum +=
          has_neighbour[incidence.left(place.edge).value] || has_neighbour[incidence.right(place.edge).value];
  return sum;
}

// Also how many edges stay non-convex, as far as a plane cut is to be believed.
std::pair<double, int> dihedral_term(const std::vector<DividedAngle>& angles, const CuttingLoop& loop,
                                     Angle limit) {
  double smallest = limit.radians();
  int open = 0;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    if (loop.steps[k].extension != Extension::none) continue;
    smallest = angles[k].inside ? std::min({smallest, angles[k].left, angles[k].right}) : 0;
    for (const double angle : {angles[k].left, angles[k].right})
      open += angles[k].inside && angle >= std::numbers::pi;
    if (!angles[k].inside) break;
  }
  return {limit.radians() > 0 ? (limit.radians() - smallest) / limit.radians() : 0, open};
}

void set_total(LoopCost& cost, const CostOptions& weight) {
  cost.total = weight.length * cost.length + weight.auxiliary_edge * cost.auxiliary_edges +
               weight.auxiliary_vertex * cost.auxiliary_vertices + weight.face_size * cost.face_size +
               weight.planarity * cost.planarity + weight.direction * cost.direction +
               weight.dihedral * cost.dihedral + weight.t_joint * cost.t_joints + weight.flat * cost.flat +
               weight.hexahedra * cost.hexahedra + weight.non_convex * cost.non_convex;
}

void check_weight(const char* field, double value) {
  if (!(value >= 0) || !std::isfinite(value))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("CostOptions::{} is {}, range 0 or more", field, value));
}

void check_sizes(const CellGraph& graph, const CellGeometry& geometry) {
  const auto points = geometry.points.cols();
  const std::size_t flags = geometry.has_neighbour.size(), faces = graph.faces.size();
  if ((points != 0 && points != graph.vertex_count) || (flags != 0 && flags != faces))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format(
            "a cell of {} vertices and {} faces has {} points and {} marks of neighbours; give one for "
            "each or none",
            graph.vertex_count, faces, points, flags));
}

}  // namespace

void validate(const CostOptions& options) {
  const std::pair<const char*, double> weights[] = {{"length", options.length},
                                                    {"auxiliary_edge", options.auxiliary_edge},
                                                    {"auxiliary_vertex", options.auxiliary_vertex},
                                                    {"face_size", options.face_size},
                                                    {"planarity", options.planarity},
                                                    {"direction", options.direction},
                                                    {"dihedral", options.dihedral},
                                                    {"t_joint", options.t_joint},
                                                    {"flat", options.flat},
                                                    {"divided", options.divided},
                                                    {"hexahedra", options.hexahedra},
                                                    {"non_convex", options.non_convex}};
  for (const auto& [field, value] : weights) check_weight(field, value);
  if (!(options.dihedral_limit >= Angle::degrees(0) && options.dihedral_limit <= Angle::degrees(180)))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("CostOptions::dihedral_limit is {} degrees, range 0 .. 180",
                            options.dihedral_limit.degrees()));
  if (options.exact_up_to < 4 || options.exact_up_to > 16)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("CostOptions::exact_up_to is {}, range 4 .. 16", options.exact_up_to));
}

LoopCost loop_cost(const CellGraph& graph, const CellIncidence& incidence, const CellGeometry& geometry,
                   const CuttingLoop& loop, const CutPieces& pieces, HexahedraCount& count,
                   const CostOptions& options) {
  check_sizes(graph, geometry);
  LoopCost cost;
  cost.length = std::abs(loop.length() - 4);
  cost.auxiliary_edges = loop.auxiliary_edges();
  cost.auxiliary_vertices = loop.auxiliary_vertices();
  cost.face_size = face_size_term(graph, loop, pieces);
  cost.t_joints = t_joint_term(incidence, geometry.has_neighbour, loop);
  for (const DerivedGraph* piece : {&pieces.left, &pieces.right}) {
    cost.hexahedra += count.estimate(piece->graph, options.exact_up_to);
    cost.non_convex += non_convex_count(piece->graph);
    cost.flat += flat_count(piece->graph);
  }
  if (geometry.points.cols() > 0) {
    cost.planarity = unevenness(place_points(graph, geometry.points, loop));
    cost.direction = indirection(graph, incidence, geometry.points, loop);
    const auto [term, open] =
        dihedral_term(divided_angles(graph, incidence, geometry.points, loop), loop, options.dihedral_limit);
    cost.dihedral = term;
    cost.non_convex += open;
  }
  set_total(cost, options);
  return cost;
}

double cell_cost(const CellGraph& graph, HexahedraCount& count, const CostOptions& options) {
  return options.hexahedra * count.estimate(graph, options.exact_up_to) +
         options.non_convex * non_convex_count(graph) + options.flat * flat_count(graph);
}

}  // namespace isopatch::segmentation
