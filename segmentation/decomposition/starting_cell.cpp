#include "segmentation/decomposition/starting_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/topology/graph_connectivity.hpp"
#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"
#include "segmentation/decomposition/prepare.hpp"

namespace isopatch::segmentation {
namespace {

/// Edges must be much longer than what counts as one point while cutting, 1e-7 of the size.
constexpr double shortest_share = 1e-6;

void require_lengths(const geometry::Brep& solid) {
  for (std::size_t e = 0; e < solid.edges().size(); ++e) {
    const EdgeId edge(static_cast<int>(e));
    const double length = solid.edge(edge).length;
    if (length > shortest_share * solid.size()) continue;
    throw geometry::SolidError(
        ErrorCode::unsupported,
        fmt::format("{} is only {:.3g} m long, {:.1g} of the solid's size; edges must be longer than {:g} of "
                    "it: remove it in the CAD program",
                    describe(solid, edge), length, length / solid.size(), shortest_share),
        {.edges = {drawn(solid, edge)}});
  }
}

void require_contractible(const geometry::Brep& solid) {
  const geometry::EdgeGraph graph = edge_graph(solid);
  const geometry::TopologyReport report = topology(graph, boundary(graph));
  if (report.genus == 0) return;
  throw geometry::SolidError(
      ErrorCode::not_contractible,
      fmt::format("{} hole{} lead{} through it; cut the solid through {} in the CAD program", report.genus,
                  report.genus == 1 ? "" : "s", report.genus == 1 ? "s" : "",
                  report.genus == 1 ? "it" : "each of them"),
      {});
}

/// Triangles that stand for a smooth body are not sides to keep: cut as such, each would have hexahedra of
/// its own.
void require_few_triangles(const geometry::Brep& solid, const CellGraph& sides) {
  constexpr std::size_t many = 200;
  const auto triangles = std::count_if(sides.faces.begin(), sides.faces.end(),
                                       [](const auto& face) { return face.size() == 3; });
  const auto smooth = std::count_if(sides.edges.begin(), sides.edges.end(), [](const CellGraph::Edge& edge) {
    return edge.angle && std::abs(edge.angle->degrees() - 180) < 45;
  });
  if (sides.faces.size() < many || 10 * static_cast<std::size_t>(triangles) < 9 * sides.faces.size() ||
      2 * static_cast<std::size_t>(smooth) < sides.edges.size())
    return;
  const auto is_triangle = [&](const geometry::BrepFace& face) {
    return face.loops.size() == 1 && face.loops.front().size() == 3;
  };
  const auto first = std::find_if(solid.faces().begin(), solid.faces().end(), is_triangle);
  const FaceId such(static_cast<int>(first - solid.faces().begin()));
  const bool any = first != solid.faces().end();
  throw geometry::SolidError(
      ErrorCode::unsupported,
      fmt::format(
          "{} of its {} sides are triangles, most of which meet at blunt edges: they stand for smooth "
          "faces{}; reconstruct those first (isopatch reconstruct), or give the solid as a STEP file of "
          "the CAD program",
          triangles, sides.faces.size(), any ? fmt::format(", as {} does", describe(solid, such)) : ""),
      any ? geometry::SolidFault{.faces = {{such.value}}} : geometry::SolidFault{});
}

void require_three_connected(const geometry::Brep& solid, const CellGraph& sides) {
  if (is_three_connected(sides)) return;
  const geometry::EdgeGraph graph = edge_graph(solid);
  const auto report = connectivity(graph, topology(graph, boundary(graph)));
  std::string where;
  geometry::SolidFault fault;
  if (const auto& conflict = report.conflict) {
    where = fmt::format(": {} and {} meet in {} and in {} without the edge between them",
                        describe(solid, conflict->first), describe(solid, conflict->second),
                        describe(solid, conflict->u), describe(solid, conflict->v));
    fault.faces = {{conflict->first.value}, {conflict->second.value}};
    fault.points = {{"one place", solid.vertex(conflict->u)}, {"the other", solid.vertex(conflict->v)}};
  }
  throw geometry::SolidError(
      ErrorCode::not_three_connected,
      fmt::format("its edge graph is not 3-connected{}; cut the solid there in the CAD program", where),
      std::move(fault));
}

}  // namespace

StartingCell starting_cell(CellStore& store) {
  StartingCell start{prepared(store.source()), {}};
  require_lengths(store.source());
  require_contractible(store.source());
  start.cell = store.add(start.complex, geometry::CellId(0));
  require_few_triangles(store.source(), start.cell.graph);
  require_three_connected(store.source(), start.cell.graph);
  return start;
}

}  // namespace isopatch::segmentation
