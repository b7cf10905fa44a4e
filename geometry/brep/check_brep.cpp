#include "geometry/brep/check_brep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::geometry {
namespace {

EdgeId shortest(const Brep& brep) {
  const auto& edges = brep.edges();
  const auto found = std::min_element(
      edges.begin(), edges.end(), [](const BrepEdge& a, const BrepEdge& b) { return a.length < b.length; });
  return EdgeId(static_cast<int>(found - edges.begin()));
}

template <class IdType>
std::string numbers(const std::vector<IdType>& ids) {
  constexpr std::size_t most = 8;
  std::vector<int> values;
  for (std::size_t i = 0; i < std::min(most, ids.size()); ++i) values.push_back(ids[i].value);
  return fmt::format("{}{}", fmt::join(values, ", "), ids.size() > most ? ", ..." : "");
}

const char* plural(std::size_t count) {
  return count == 1 ? "" : "s";
}

void add_topology_findings(const TopologyReport& topology, int shells, std::vector<std::string>& findings) {
  if (shells > 1)
    findings.push_back(fmt::format("{} shells: the solid has cavities or is in pieces", shells));
  if (topology.genus > 0)
    findings.push_back(fmt::format("genus {}: {} through-hole{} or handle{} to cut open", topology.genus,
                                   topology.genus, plural(static_cast<std::size_t>(topology.genus)),
                                   plural(static_cast<std::size_t>(topology.genus))));
  if (const auto& faces = topology.with_inner_loops; !faces.empty())
    findings.push_back(fmt::format("face{} {} with inner loops", plural(faces.size()), numbers(faces)));
  if (const auto& faces = topology.periodic; !faces.empty())
    findings.push_back(
        fmt::format("periodic face{} {}, closed by a seam", plural(faces.size()), numbers(faces)));
  if (const auto& edges = topology.closed_edges; !edges.empty())
    findings.push_back(
        fmt::format("closed edge{} {}, with one vertex only", plural(edges.size()), numbers(edges)));
}

void add_connectivity_findings(const Brep& brep, const ConnectivityReport& connectivity,
                               std::vector<std::string>& findings) {
  if (!connectivity.connected) findings.emplace_back("the edge graph falls into pieces");
  if (const auto& edges = connectivity.parallel; !edges.empty())
    findings.push_back(fmt::format("edge{} {} between vertices that another edge joins already",
                                   plural(edges.size()), numbers(edges)));
  if (const auto& vertices = connectivity.low_degree; !vertices.empty())
    findings.push_back(fmt::format("{} {} with fewer than three edges",
                                   vertices.size() == 1 ? "vertex" : "vertices", numbers(vertices)));
  if (const auto& conflict = connectivity.conflict; conflict && conflict->first == conflict->second)
    findings.push_back(
        fmt::format("{} touches itself in {}", describe(brep, conflict->first), describe(brep, conflict->u)));
  else if (conflict)
    findings.push_back(
        fmt::format("{} and {} meet in {} and in {} without the edge between them: removing these two "
                    "vertices takes the edge graph apart",
                    describe(brep, conflict->first), describe(brep, conflict->second),
                    describe(brep, conflict->u), describe(brep, conflict->v)));
}

void add_angle_findings(const BrepReport& report, std::vector<std::string>& findings) {
  for (const auto& [kind, advice] : {std::pair(Convexity::non_convex, "to be removed by the first cuts"),
                                     std::pair(Convexity::flat, "that make poor corners")}) {
    std::vector<EdgeId> edges;
    for (std::size_t i = 0; i < report.angles.size(); ++i)
      if (report.angles[i].convexity == kind) edges.emplace_back(static_cast<int>(i));
    if (!edges.empty())
      findings.push_back(fmt::format("{} {} edge{} {}: {}", edges.size(), name(kind), plural(edges.size()),
                                     numbers(edges), advice));
  }
}

BrepStage stage_of(const EdgeGraph& graph, const BrepReport& report) {
  if (!report.contradictions.empty()) return BrepStage::repair;
  if (!report.connectivity.three_connected) return BrepStage::preprocessing;
  return is_cube(graph, report.connectivity) ? BrepStage::parameterization : BrepStage::decomposition;
}

void add_quadrature_findings(const BrepReport& report, std::vector<std::string>& findings) {
  for (const auto& [what, value, error] : {std::tuple("volume", report.volume, report.volume_error),
                                           std::tuple("surface", report.area, report.area_error)})
    if (!Measure{value, error}.converged())
      findings.push_back(fmt::format("the {} is known to {:.1g} of itself only, not to {:g}", what,
                                     error / std::abs(value), Measure::promised));
}

}  // namespace

const char* name(BrepStage stage) {
  switch (stage) {
    case BrepStage::repair:
      return "repair";
    case BrepStage::preprocessing:
      return "preprocessing";
    case BrepStage::decomposition:
      return "decomposition";
    case BrepStage::parameterization:
      break;
  }
  return "parameterization";
}

int BrepReport::count(Convexity convexity) const {
  return static_cast<int>(std::count_if(angles.begin(), angles.end(),
                                        [&](const EdgeAngles& edge) { return edge.convexity == convexity; }));
}

BrepReport check(const Brep& brep, const CheckOptions& options) {
  const EdgeGraph graph = edge_graph(brep);
  BrepReport report;
  report.boundary = boundary(graph);
  report.topology = topology(graph, report.boundary);
  report.connectivity = connectivity(graph, report.topology);
  report.angles = edge_angles(brep, options.angles);
  report.area = brep.area();
  report.area_error = brep.measured_area().error;
  report.gap = largest_gap(brep);
  report.largest_gap = report.gap.distance;
  report.shortest_edge = shortest(brep);
  report.contradictions = contradictions(brep, report.boundary, options.soundness);
  const std::string problem = boundary_problem(brep, report.boundary);
  if (!problem.empty()) report.findings.push_back(problem);
  for (const Contradiction& found : report.contradictions) report.findings.push_back(found.text);
  if (!problem.empty()) return report;
  report.volume = brep.volume();
  report.volume_error = brep.measured_volume().error;
  add_topology_findings(report.topology, report.boundary.shells, report.findings);
  add_connectivity_findings(brep, report.connectivity, report.findings);
  report.stage = stage_of(graph, report);
  if (report.stage != BrepStage::parameterization || report.count(Convexity::non_convex) > 0)
    add_angle_findings(report, report.findings);
  add_quadrature_findings(report, report.findings);
  return report;
}

}  // namespace isopatch::geometry
