#include "app/problem/applied_region.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/base/engineering_units.hpp"
#include "app/problem/edge_selection.hpp"

namespace isopatch::app {
namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// Whether the study's names say more than the labels of the faces.
bool has_names(const AppliedRegion& region) {
  return std::any_of(region.given.begin(), region.given.end(), [&](const std::string& name) {
    return std::find(region.faces.begin(), region.faces.end(), name) == region.faces.end();
  });
}

/// "bore, top and 3 more".
std::string short_names(const AppliedRegion& region) {
  constexpr std::size_t most = 4;
  std::vector<std::string> names = region.given;
  const std::size_t more = names.size() > most ? names.size() - most + 1 : 0;
  if (more > 0) names.resize(most - 1);
  return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string faces_text(const AppliedRegion& region) {
  const std::string count = counted(region.faces.size(), "face", "faces");
  return has_names(region) ? fmt::format("{} ({})", short_names(region), count) : count;
}

}  // namespace

AppliedRegion region_of(const std::string& name, std::string_view kind,
                        const std::vector<geometry::PatchFace>& faces, const ModelReport& report) {
  AppliedRegion region{name, std::string(kind), {}, 0, {}, 0};
  for (const BoundaryFaceReport& face : report.boundary_faces) {
    if (std::find(faces.begin(), faces.end(), face.face) == faces.end()) continue;
    region.faces.push_back(face.label);
    region.area += face.area;
  }
  return region;
}

AppliedRegion region_of(const std::string& name, std::string_view kind, const std::vector<PatchId>& patches,
                        const ModelReport& report) {
  AppliedRegion region{name, std::string(kind), {}, 0, {}, 0};
  for (const PatchId id : patches) {
    region.patches.push_back(id.value);
    region.volume += report.patches[static_cast<std::size_t>(id.value)].volume;
  }
  return region;
}

AppliedRegion region_of(const std::string& name, std::string_view kind,
                        const std::vector<iga::SupportedEdge>& edges, const geometry::MultiPatch& model) {
  AppliedRegion region{name, std::string(kind), {}, 0, {}, 0};
  for (const iga::SupportedEdge& held : edges) region.edges.push_back(label(model, held));
  return region;
}

std::string region_text(const AppliedRegion& region) {
  if (!region.patches.empty())
    return fmt::format("{}: {} in {}, {}", region.name, region.kind,
                       counted(region.patches.size(), "patch", "patches"), with_unit(region.volume, "m^3"));
  if (region.length > 0)
    return fmt::format("{}: {} along a line of {}", region.name, region.kind, with_unit(region.length, "m"));
  if (region.points > 0)
    return fmt::format("{}: {} at {}", region.name, region.kind,
                       counted(static_cast<std::size_t>(region.points), "point", "points"));
  if (region.faces.empty() && region.edges.empty())
    return fmt::format("{}: {}, holds the motions that other supports leave", region.name, region.kind);
  if (!region.edges.empty())
    return fmt::format("{}: {} on {} of patches", region.name, region.kind,
                       counted(region.edges.size(), "edge", "edges"));
  return fmt::format("{}: {} on {}{}, {}", region.name, region.kind, region.is_part ? "part of " : "",
                     faces_text(region), with_unit(region.area, "m^2"));
}

}  // namespace isopatch::app
