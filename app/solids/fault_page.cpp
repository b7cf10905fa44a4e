#include "app/solids/fault_page.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "app/base/engineering_units.hpp"
#include "app/base/internal/json_values.hpp"
#include "app/base/provenance.hpp"
#include "app/pages/page.hpp"
#include "app/results/summary.hpp"
#include "app/solids/solid_outlines.hpp"

namespace isopatch::app {
namespace {

using geometry::SolidError;
using geometry::SolidFault;

/// "part: face 3 'top'".
std::string label(const OutlinedSolid& solid, std::size_t face) {
  const std::string& own = solid.faces[face].name;
  const std::string number = fmt::format("face {}", face);
  return solid.name + ": " + (own.empty() || own == number ? number : fmt::format("{} '{}'", number, own));
}

const SolidFault::Face* fault_at(const SolidFault& fault, const std::string& solid, std::size_t face) {
  const auto found = std::find_if(fault.faces.begin(), fault.faces.end(), [&](const SolidFault::Face& f) {
    return f.solid == solid && f.number == static_cast<int>(face);
  });
  return found == fault.faces.end() ? nullptr : &*found;
}

/// What is wrong, and edges without their neighbours, which the message names only the first of.
SolidFault all_faults(const SolidError& error, const std::vector<OutlinedSolid>& solids) {
  SolidFault fault = error.fault();
  const bool has_edges = std::any_of(
      solids.begin(), solids.end(), [](const OutlinedSolid& solid) { return !solid.boundary.edges.empty(); });
  if (has_edges) fault.edges.clear();  // they are among those
  for (const OutlinedSolid& solid : solids) {
    const SolidFault found = of_solid(solid.boundary, solid.name);
    for (const auto& edge : found.edges) fault.edges.push_back({solid.name + ": " + edge.name, edge.points});
    for (const auto& point : found.points)
      fault.points.push_back({solid.name + ": " + point.name, point.point});
  }
  return fault;
}

FaultScene scene_of(const std::vector<OutlinedSolid>& solids, const SolidFault& fault) {
  FaultScene scene;
  Eigen::AlignedBox3d box;
  for (const OutlinedSolid& solid : solids) {
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
      const SolidFault::Face* wrong = fault_at(fault, solid.name, f);
      const OutlinedFace& face = solid.faces[f];
      scene.faces.push_back(
          {label(solid, f), wrong ? wrong->remark : "", wrong != nullptr, face.points, face.triangles});
    }
    for (const Eigen::Matrix3Xd& line : solid.lines) {
      scene.lines.push_back({"", false, line});
      for (const auto& point : line.colwise()) box.extend(Eigen::Vector3d(point));
    }
  }
  for (const SolidFault::Edge& edge : fault.edges) scene.lines.push_back({edge.name, true, edge.points});
  for (const SolidFault::Point& point : fault.points) scene.places.push_back({point.name, point.point});
  scene.length = model_length_unit(box.isEmpty() ? 1 : box.diagonal().norm());
  return scene;
}

Json summary_of(const std::string& message, const std::vector<OutlinedSolid>& solids) {
  Json list = Json::array();
  for (const OutlinedSolid& solid : solids)
    list.push_back({{"name", solid.name},
                    {"file", solid.file},
                    {"faces", solid.faces.size()},
                    {"edges", solid.edge_count},
                    {"vertices", solid.vertex_count},
                    {"state", solid.state}});
  return {{"message", message}, {"solids", list}};
}

}  // namespace

std::string fault_html(const BlocksInput& input, const SolidError& error, const std::string& title,
                       const std::string& study) {
  const std::vector<OutlinedSolid> solids = outlined_solids(input.files);
  Page page;
  page.kind = "faults";
  page.program = fmt::format("isopatch {}", version());
  page.title = title;
  page.study = study;
  page.summary_json = summary_of(error.what(), solids).dump(-1, ' ', false, Json::error_handler_t::replace);
  page.faults = scene_of(solids, all_faults(error, solids));
  return to_html(page);
}

std::string shown_in(const SolidError& error, const std::filesystem::path& page) {
  return fmt::format("{}\n  {} shows where", error.what(), page.string());
}

}  // namespace isopatch::app
