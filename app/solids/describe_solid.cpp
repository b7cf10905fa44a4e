#include "app/solids/describe_solid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "app/base/engineering_units.hpp"
#include "app/base/internal/cut_list.hpp"
#include "app/base/internal/json_values.hpp"

namespace isopatch::app {
namespace {

using geometry::Brep;
using geometry::BrepEdge;
using geometry::BrepFace;
using geometry::BrepReport;
using geometry::Convexity;

const char* yes(bool holds, const char* if_so, const char* if_not) {
  return holds ? if_so : if_not;
}

std::string boundary_text(const BrepReport& report) {
  const auto& boundary = report.boundary;
  std::string text =
      fmt::format("{}, {}, {}, {}", yes(boundary.closed(), "closed", "open"),
                  yes(boundary.manifold(), "manifold", "not manifold"),
                  yes(boundary.oriented(), "oriented", "not oriented"),
                  boundary.shells == 1 ? "one shell" : fmt::format("{} shells", boundary.shells));
  if (!boundary.bounds_a_solid()) return text;
  return text + fmt::format(", genus {}{}", report.topology.genus,
                            yes(report.topology.contractible, ", contractible", ""));
}

std::string graph_text(const BrepReport& report) {
  const auto& graph = report.connectivity;
  return fmt::format("{}, {}, {}{}", yes(graph.connected, "connected", "in pieces"),
                     yes(graph.simple(), "simple", "not simple"),
                     yes(graph.three_connected, "3-connected", "not 3-connected"),
                     yes(report.stage == geometry::BrepStage::parameterization, ", that of a cube", ""));
}

bool has_angle(const geometry::EdgeAngles& edge) {
  return edge.convexity != Convexity::free && edge.convexity != Convexity::overused;
}

/// "four faces".
std::string faces_in_words(std::size_t count) {
  constexpr std::array<const char*, 7> words = {"three", "four", "five", "six", "seven", "eight", "nine"};
  if (count < 3 || count - 3 >= words.size()) return fmt::format("{} faces", count);
  return fmt::format("{} faces", words[count - 3]);
}

/// ", 1 with four faces" for each number of faces there is.
std::string overused_text(const Brep& brep) {
  std::map<std::size_t, int> counts;
  for (const BrepEdge& edge : brep.edges())
    if (edge.faces.size() > 2) ++counts[edge.faces.size()];
  std::string text;
  for (const auto& [faces, count] : counts) text += fmt::format(", {} with {}", count, faces_in_words(faces));
  return text;
}

std::string edges_summary(const Brep& brep, const BrepReport& report) {
  std::string text;
  for (const Convexity kind :
       {Convexity::convex, Convexity::non_convex, Convexity::flat, Convexity::seam, Convexity::free}) {
    const int count = report.count(kind);
    if (count > 0) text += fmt::format(", {} {}", count, name(kind));
  }
  text += overused_text(brep);
  if (!text.empty()) text.erase(0, 2);
  double low = 360, high = 0;
  for (const auto& edge : report.angles) {
    if (!has_angle(edge) || edge.convexity == Convexity::seam) continue;
    low = std::min(low, edge.smallest.degrees());
    high = std::max(high, edge.largest.degrees());
  }
  return low <= high ? text + fmt::format("; inner angles {:.4g} to {:.4g} degrees", low, high) : text;
}

std::size_t edge_count(const BrepFace& face) {
  std::size_t count = 0;
  for (const auto& loop : face.loops) count += loop.size();
  return count;
}

std::string colour_text(const BrepFace& face) {
  return face.colour ? geometry::hex_text(*face.colour) : "";
}

std::string faces_text(const Brep& brep, bool all) {
  const std::size_t total = brep.faces().size(), shown = all ? total : std::min(short_list, total);
  std::string text = fmt::format("\nfaces\n  {:>4}  {:<9} {:>6} {:>6} {:>12}  {}\n", "no", "surface", "edges",
                                 "loops", "area", "colour and name");
  for (std::size_t i = 0; i < shown; ++i) {
    const BrepFace& face = brep.faces()[i];
    std::string line = fmt::format(
        "  {:>4}  {:<9} {:>6} {:>6} {:>12}  {} {}", i, name(face.kind), edge_count(face), face.loops.size(),
        with_unit(brep.area(FaceId(static_cast<int>(i))), "m^2"), colour_text(face), face.name);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text + cut(shown, total, "faces");
}

std::string angle_text(const geometry::EdgeAngles& angles) {
  if (!has_angle(angles)) return "";
  const double low = angles.smallest.degrees(), high = angles.largest.degrees();
  if (high - low < 0.05) return fmt::format("{:.1f}", low);
  return fmt::format("{:.1f} to {:.1f}", low, high);
}

std::string kind_text(const BrepEdge& edge, const geometry::EdgeAngles& angles) {
  return angles.convexity == Convexity::overused ? faces_in_words(edge.faces.size()) : name(angles.convexity);
}

std::vector<int> numbers(const std::vector<FaceId>& faces) {
  std::vector<int> result;
  for (const FaceId face : faces) result.push_back(face.value);
  return result;
}

std::string edges_text(const Brep& brep, const BrepReport& report, bool all) {
  const std::size_t total = brep.edges().size(), shown = all ? total : std::min(short_list, total);
  std::string text = fmt::format("\nedges\n  {:>4}  {:<8} {:>9}  {:<9} {:>10}  {:<10} {}\n", "no", "curve",
                                 "vertices", "faces", "length", "kind", "inner angle, degrees");
  for (std::size_t i = 0; i < shown; ++i) {
    const BrepEdge& edge = brep.edges()[i];
    text += fmt::format("  {:>4}  {:<8} {:>9}  {:<9} {:>10}  {:<10} {}\n", i, name(edge.kind),
                        fmt::format("{}-{}", edge.start.value, edge.end.value),
                        fmt::format("{}", fmt::join(numbers(edge.faces), ", ")), with_unit(edge.length, "m"),
                        kind_text(edge, report.angles[i]), angle_text(report.angles[i]));
  }
  return text + cut(shown, total, "edges");
}

std::string findings_text(const BrepReport& report) {
  std::string text = fmt::format("ready for {}\n", name(report.stage));
  for (const std::string& finding : report.findings) text += "  - " + finding + "\n";
  return text;
}

Json face_json(const Brep& brep, std::size_t index) {
  const BrepFace& face = brep.faces()[index];
  Json loops = Json::array();
  for (const auto& loop : face.loops) {
    Json uses = Json::array();
    for (const auto& use : loop) uses.push_back({{"edge", use.edge.value}, {"reversed", use.reversed}});
    loops.push_back(uses);
  }
  Json colour;
  if (face.colour) colour = *face.colour;
  return {{"name", face.name},
          {"colour", colour},
          {"surface", name(face.kind)},
          {"area", brep.area(FaceId(static_cast<int>(index)))},
          {"loops", loops}};
}

Json edge_json(const BrepEdge& edge, const geometry::EdgeAngles& angles) {
  return {{"vertices", {edge.start.value, edge.end.value}},
          {"faces", numbers(edge.faces)},
          {"curve", name(edge.kind)},
          {"length", edge.length},
          {"convexity", name(angles.convexity)},
          {"smallest_angle", angles.smallest.degrees()},
          {"largest_angle", angles.largest.degrees()}};
}

template <class IdType>
Json ids_json(const std::vector<IdType>& ids) {
  Json result = Json::array();
  for (const IdType id : ids) result.push_back(id.value);
  return result;
}

Json checks_json(const BrepReport& report) {
  const auto& boundary = report.boundary;
  const auto& graph = report.connectivity;
  Json conflict;
  if (graph.conflict)
    conflict = {{"faces", {graph.conflict->first.value, graph.conflict->second.value}},
                {"vertices", {graph.conflict->u.value, graph.conflict->v.value}}};
  return {{"closed", boundary.closed()},
          {"manifold", boundary.manifold()},
          {"oriented", boundary.oriented()},
          {"shells", boundary.shells},
          {"free_edges", ids_json(boundary.free_edges)},
          {"overused_edges", ids_json(boundary.overused_edges)},
          {"misoriented_edges", ids_json(boundary.misoriented_edges)},
          {"pinched_vertices", ids_json(boundary.pinched_vertices)},
          {"euler_characteristic", report.topology.euler_characteristic},
          {"genus", report.topology.genus},
          {"contractible", report.topology.contractible},
          {"faces_with_inner_loops", ids_json(report.topology.with_inner_loops)},
          {"periodic_faces", ids_json(report.topology.periodic)},
          {"closed_edges", ids_json(report.topology.closed_edges)},
          {"connected", graph.connected},
          {"simple", graph.simple()},
          {"three_connected", graph.three_connected},
          {"conflict", conflict}};
}

Json gap_json(const geometry::EdgeGap& gap) {
  return {{"face", gap.face.value}, {"edge", gap.edge.value}, {"point", to_json(gap.place)}};
}

/// Null for what is no solid.
Json outlook_json(const SolidReport& solid) {
  if (solid.report.stage == geometry::BrepStage::repair) return {};
  const auto& prospect = solid.prospect;
  const bool refused = prospect && prospect->refusal;
  Json json = {{"state", !prospect ? "hexahedron" : refused ? "refused" : "to be cut"}};
  if (prospect && !refused) json["seen_as"] = prospect->seen_as;
  if (refused) json["reason"] = prospect->refusal->what();
  if (prospect && !refused) {
    json["faces"] = prospect->sides;
    json["concave_edges"] = ids_json(prospect->concave);
    json["nearly_flat_edges"] = ids_json(prospect->blunt);
  }
  return json;
}

Json solid_json(const SolidReport& solid) {
  const Brep& brep = solid.file.brep;
  const BrepReport& report = solid.report;
  Json contradictions = Json::array();
  for (const geometry::Contradiction& found : report.contradictions) contradictions.push_back(found.text);
  Json faces = Json::array(), edges = Json::array(), vertices = Json::array();
  for (std::size_t i = 0; i < brep.faces().size(); ++i) faces.push_back(face_json(brep, i));
  for (std::size_t i = 0; i < brep.edges().size(); ++i)
    edges.push_back(edge_json(brep.edges()[i], report.angles[i]));
  for (const auto& vertex : brep.vertices().colwise()) vertices.push_back(to_json(Eigen::Vector3d(vertex)));
  return {{"name", solid.file.name},
          {"stage", name(report.stage)},
          {"findings", report.findings},
          {"segmentation", outlook_json(solid)},
          {"volume", report.volume},
          {"volume_error", report.volume_error},
          {"area", report.area},
          {"area_error", report.area_error},
          {"box", {to_json(brep.box()[0]), to_json(brep.box()[1])}},
          {"largest_correction", solid.file.largest_correction},
          {"largest_gap", report.largest_gap},
          {"largest_gap_at", gap_json(report.gap)},
          {"contradictions", contradictions},
          {"checks", checks_json(report)},
          {"faces", faces},
          {"edges", edges},
          {"vertices", vertices}};
}

/// A measure with its unit, and a remark where its integral has not converged.
std::string measure_text(double value, double error, const char* unit) {
  std::string text = with_unit(value, unit);
  if (geometry::Measure{value, error}.converged()) return text;
  return text + fmt::format(" (known to {:.1g} of itself only)", error / std::abs(value));
}

/// Nothing where the gap is one of round-off and of the tolerance that programs write their files with.
std::string gap_place(const geometry::EdgeGap& gap, double size) {
  if (!(gap.distance > 1e-6 * size)) return "";
  return fmt::format(" (edge {}, face {}, at {})", gap.edge.value, gap.face.value,
                     place_with_unit(gap.place, size));
}

}  // namespace

std::string outlook_text(const std::optional<segmentation::Prospect>& prospect) {
  if (!prospect) return "a topological hexahedron, a block as it is";
  if (prospect->refusal) return fmt::format("refused: {}", prospect->refusal->what());
  const bool known = !prospect->seen_as.empty();
  if (known && prospect->sides == 0) return "looks " + prospect->seen_as;
  const auto listed = [](const std::vector<EdgeId>& edges, const char* one, const char* several) {
    constexpr std::size_t most = 8;
    const std::size_t shown = std::min(most, edges.size());
    std::vector<int> numbers;
    for (std::size_t i = 0; i < shown; ++i) numbers.push_back(edges[i].value);
    return fmt::format("{} {} ({}{})", edges.size(), edges.size() == 1 ? one : several,
                       fmt::join(numbers, ", "), shown < edges.size() ? ", ..." : "");
  };
  std::string text = known ? "looks " + prospect->seen_as + ", or is cut if that takes fewer hexahedra: "
                           : "cuts will be looked for: ";
  text += fmt::format("{} faces, ", prospect->sides);
  text += prospect->concave.empty() ? "all edges convex"
                                    : listed(prospect->concave, "concave edge", "concave edges");
  if (!prospect->blunt.empty())
    text += ", " + listed(prospect->blunt, "tangent or nearly flat one", "tangent or nearly flat ones") +
            ", where cuts may be refused";
  return text;
}

std::string solid_text(const SolidReport& solid, bool all) {
  const Brep& brep = solid.file.brep;
  const BrepReport& report = solid.report;
  std::string text = fmt::format("{} faces, {} edges, {} vertices: {}\n", brep.faces().size(),
                                 brep.edges().size(), brep.vertices().cols(), boundary_text(report));
  text += fmt::format("edge graph {}\n", graph_text(report));
  text += fmt::format("edges {}\n", edges_summary(brep, report));
  text += fmt::format("volume {}, surface {}\n", measure_text(report.volume, report.volume_error, "m^3"),
                      measure_text(report.area, report.area_error, "m^2"));
  text += fmt::format("box {} to {}\n", place_with_unit(brep.box()[0], brep.size()),
                      place_with_unit(brep.box()[1], brep.size()));
  text += fmt::format("largest gap between an edge and its face {}{}, shortest edge {} ({})\n",
                      with_unit(report.largest_gap, "m"), gap_place(report.gap, brep.size()),
                      report.shortest_edge.value, with_unit(brep.edge(report.shortest_edge).length, "m"));
  if (solid.file.largest_correction > 0)
    text += fmt::format("sewn: points moved by up to {}\n", with_unit(solid.file.largest_correction, "m"));
  if (!solid.recognised.empty()) text += fmt::format("{}, and cut as such\n", solid.recognised);
  if (report.stage != geometry::BrepStage::repair)
    text += fmt::format("segmentation: {}\n", outlook_text(solid.prospect));
  return text + findings_text(report) + faces_text(brep, all) + edges_text(brep, report, all);
}

std::string solids_json_text(const std::vector<SolidReport>& solids, const std::string& unit,
                             const std::vector<std::string>& warnings) {
  Json result = Json::array();
  for (const SolidReport& solid : solids) result.push_back(solid_json(solid));
  return file_text({{"bodies", solids.size()}, {"unit", unit}, {"warnings", warnings}, {"solids", result}});
}

}  // namespace isopatch::app
