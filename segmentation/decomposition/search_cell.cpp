#include "segmentation/decomposition/search_cell.hpp"

#include <algorithm>
#include <utility>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"
#include "segmentation/decomposition/cutting/inside.hpp"
#include "segmentation/decomposition/cutting/side_inside.hpp"
#include "segmentation/decomposition/cutting/vertex_on_chain.hpp"

namespace isopatch::segmentation {

using geometry::CellComplex;
using geometry::CellId;

SearchCell CellStore::add(const CellComplex& complex, CellId cell) {
  Entry entry{complex, CellId(0), {}, false, {}};
  entry.complex.cells = {complex.cell(cell)};
  entry.sides = cell_sides(CellShapes(source_, entry.complex), CellId(0), options_.sides);
  entry.polyhedral = is_polyhedral(CellShapes(source_, entry.complex), CellId(0));
  SearchCell result;
  result.graph = entry.sides.graph;
  for (CellGraph::Edge& edge :
       result.graph.edges)  // a hexahedron has no use for an angle that is nearly flat
    if (edge.angle && edge.angle->degrees() > options_.largest_angle.degrees())
      edge.kind = EdgeKind::non_convex;
  result.geometry.points.resize(3, static_cast<Eigen::Index>(entry.sides.vertices.size()));
  for (std::size_t v = 0; v < entry.sides.vertices.size(); ++v)
    result.geometry.points.col(static_cast<Eigen::Index>(v)) = complex.vertex(entry.sides.vertices[v]);
  for (const auto& side : entry.sides.faces)
    result.geometry.has_neighbour.push_back(std::any_of(
        side.begin(), side.end(), [&](const auto& use) { return !complex.face(use.face).origin; }));
  result.handle = static_cast<int>(entries_.size());
  entries_.push_back(std::move(entry));
  return result;
}

CutAnswer CellStore::refused(const std::string& why) {
  std::string reason;
  for (const char c : why)
    if (c != '.' && (c < '0' || c > '9')) reason += c;
  ++refusals_[reason];
  return {{}, why};
}

namespace {

/// Whether a surface is known through a loop, as far as its places tell.
bool has_surface(const SearchCell& cell, const CuttingLoop& loop, bool cell_is_polyhedral, double tolerance) {
  if (loop.length() <= (cell_is_polyhedral ? 3 : 4)) return true;
  Eigen::Matrix3Xd points(3, loop.length());
  for (int i = 0; i < loop.length(); ++i) {
    const LoopPlace& place = loop.places[static_cast<std::size_t>(i)];
    const Eigen::Matrix3Xd& corners = cell.geometry.points;
    if (place.auxiliary()) {
      const CellGraph::Edge& edge = cell.graph.edge(place.edge);
      points.col(i) = (corners.col(edge.start.value) + corners.col(edge.end.value)) / 2;
    } else {
      points.col(i) = corners.col(place.vertex.value);
    }
  }
  const Eigen::Vector3d centre = points.rowwise().mean();
  const Eigen::Matrix3Xd arms = points.colwise() - centre;
  const Eigen::Vector3d normal = symmetric_eigen(arms * arms.transpose()).vectors.col(0);
  return (normal.transpose() * arms).cwiseAbs().maxCoeff() <= tolerance;
}

/// What the edges inside a cell's sides will cost, in hexahedra: the cell has to be cut along them, into
/// others than hexahedra where they end in its corners or inside a side.
double cost_of_parts(const CellComplex& complex, const CellSides& sides) {
  double cost = 0;
  for (const auto& side : sides.faces) {
    if (side.size() < 2) continue;
    const SideInside inside = side_inside(complex, side);
    for (const EdgeId edge : inside.edges) {
      cost += 1;
      for (const VertexId end : {complex.edge(edge).start, complex.edge(edge).end}) {
        const bool corner =
            std::find(sides.vertices.begin(), sides.vertices.end(), end) != sides.vertices.end();
        if (corner || !inside.outline.contains(end)) cost += 3;
      }
    }
  }
  return cost;
}

/// What sharp angles and short edges of a piece weigh, in hexahedra.
double penalty(const SearchCell& piece) {
  const Eigen::Matrix3Xd& points = piece.geometry.points;
  const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
  double sharpest = 30, shortest = 0.1;
  for (const CellGraph::Edge& edge : piece.graph.edges) {
    if (edge.angle) sharpest = std::min(sharpest, edge.angle->degrees());
    shortest = std::min(shortest, (points.col(edge.start.value) - points.col(edge.end.value)).norm() / size);
  }
  return 2 * (1 - sharpest / 30) + (0.1 / shortest - 1) / 2;
}

}  // namespace

CutAnswer CellStore::cut(const SearchCell& cell, const CuttingLoop& loop) {
  if (time_is_up()) return {{}, "the time is up"};
  if (const auto known = answers_.find({cell.handle, loop}); known != answers_.end()) return known->second;
  return answers_[{cell.handle, loop}] = make_cut(cell, loop);
}

CutAnswer CellStore::make_cut(const SearchCell& cell, const CuttingLoop& loop) {
  const auto proposed = proposed_.find({cell.handle, loop});
  if (proposed == proposed_.end() && !(options_.free_form && !entry(cell.handle).polyhedral) &&
      !has_surface(cell, loop, entry(cell.handle).polyhedral, 1e-7 * source_.size()))
    return refused("no surface is known through its places");
  Entry& whole = entries_[static_cast<std::size_t>(cell.handle)];
  if (whole.boundary.cols() == 0)
    whole.boundary = boundary_triangles(CellShapes(source_, whole.complex), whole.cell);
  CutAttempt attempt;
  if (proposed == proposed_.end()) {
    attempt = cut_cell(source_, whole.complex, whole.cell, whole.sides, {loop}, options_, &whole.boundary);
  } else {
    CellComplex complex = whole.complex;
    PlacedLoop placed{loop, std::vector<VertexId>(loop.places.size())};
    for (std::size_t i = 0; i < loop.places.size(); ++i)
      if (loop.places[i].auxiliary())
        placed.at[i] = vertex_on_chain(source_, complex,
                                       whole.sides.edges[static_cast<std::size_t>(loop.places[i].edge.value)],
                                       proposed->second[i], 1e-7 * source_.size());
    const CellSides sides = cell_sides(CellShapes(source_, complex), whole.cell, options_.sides);
    attempt = cut_cell(source_, std::move(complex), whole.cell, sides, placed, options_, &whole.boundary);
  }
  if (!attempt.cut) return refused(attempt.refusal);
  CutAnswer answer;
  try {
    for (const CellId piece : {attempt.cut->left, attempt.cut->right}) {
      answer.pieces.push_back(add(attempt.cut->complex, piece));
      if (!is_three_connected(answer.pieces.back().graph)) return refused("a piece would not be 3-connected");
    }
  } catch (const Error& error) {
    return refused(error.what());
  }
  double parts = -cost_of_parts(entry(cell.handle).complex, entry(cell.handle).sides);
  for (const SearchCell& piece : answer.pieces) {
    answer.penalty += penalty(piece);
    parts += cost_of_parts(entry(piece.handle).complex, entry(piece.handle).sides);
  }
  answer.penalty += std::max(0.0, parts);
  std::vector<Eigen::Vector3d>& at = places_[{cell.handle, loop}];
  for (const VertexId vertex : attempt.cut->places) at.push_back(attempt.cut->complex.vertex(vertex));
  return answer;
}

void CellStore::allow_free_form() {
  options_.free_form = true;
  std::erase_if(answers_, [](const auto& answer) { return answer.second.pieces.empty(); });
  refusals_.clear();
}

void CellStore::propose(int handle, const CuttingLoop& loop, const std::vector<Eigen::Vector3d>& places) {
  proposed_.try_emplace({handle, loop}, places);
}

std::vector<Eigen::Vector3d> CellStore::places(int handle, const CuttingLoop& loop) const {
  const auto found = places_.find({handle, loop});
  if (found == places_.end()) throw Error(ErrorCode::internal, "a cell was never cut along this loop");
  return found->second;
}

}  // namespace isopatch::segmentation
