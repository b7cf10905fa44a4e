#include "app/problem/applied_region.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/base/engineering_units.hpp"
#include "app/problem/edge_selection.hpp"

namespace isopatch::app {
namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

std::string_view name(SupportKind kind) {
  switch (kind) {
    case SupportKind::symmetry:
      return "symmetry";
    case SupportKind::roller:
      return "roller";
    case SupportKind::displacement:
      break;
  }
  return "displacement";
}

std::string_view name(LoadKind kind) {
  switch (kind) {
    case LoadKind::pressure:
      return "pressure";
    case LoadKind::force:
      return "force";
    case LoadKind::body_force:
      return "body_force";
    case LoadKind::gravity:
      return "gravity";
    case LoadKind::traction:
      break;
  }
  return "traction";
}

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
  if (!region.edges.empty())
    return fmt::format("{}: {} on {} of patches", region.name, region.kind,
                       counted(region.edges.size(), "edge", "edges"));
  return fmt::format("{}: {} on {}, {}", region.name, region.kind,
                     counted(region.faces.size(), "face", "faces"), with_unit(region.area, "m^2"));
}

}  // namespace isopatch::app
