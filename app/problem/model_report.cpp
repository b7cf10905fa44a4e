#include "app/problem/model_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/base/engineering_units.hpp"
#include "app/base/place_text.hpp"
#include "geometry/common_refinement.hpp"
#include "geometry/part_box.hpp"

namespace isopatch::app {
namespace {

using geometry::JacobianSign;
using geometry::MultiPatch;

PatchReport report_patch(const MultiPatch& model, int index, const Progress& progress) {
  const PatchId id(index);
  const auto& patch = model.patch(id);
  PatchReport result;
  for (int d = 0; d < 3; ++d) {
    const auto i = static_cast<std::size_t>(d);
    result.degree[i] = patch.degree(d);
    result.control_points[i] = patch.size(d);
    result.elements[i] = patch.knots(d).element_count();
  }
  result.rational = patch.is_rational();
  result.was_left_handed = model.was_reversed(id);
  result.volume = geometry::volume(patch);
  // Two parts of about equal length.
  const auto half = [&](double begin) {
    return Progress{[&, begin](std::string_view, double share) {
      progress("checking the patches", (index + begin + share / 2) / model.patch_count());
    }};
  };
  result.quality = geometry::quality(patch, 0, half(0));
  result.certificate = geometry::certify_jacobian(patch, {}, half(0.5));
  return result;
}

BoundaryFaceReport report_face(const MultiPatch& model, const geometry::PatchFace& face) {
  const auto& patch = model.patch(face.patch);
  const auto surface = geometry::face_surface(patch, face.side);
  const geometry::Parameter<2> middle = 0.5 * (surface.low() + surface.high());
  return {face, model.label(face), geometry::area(surface), surface.point(middle),
          geometry::outward_normal(patch, face.side, middle)};
}

}  // namespace

void add_non_matching(const MultiPatch& model, ModelReport& result) {
  const double same_point = model.tolerance().same_point * model.size();
  for (const auto& interface : model.non_matching()) {
    const auto surface = [&](const geometry::PatchFace& face) {
      return geometry::face_surface(model.patch(face.patch), face.side);
    };
    const geometry::SharedSurface shared =
        geometry::shared_surface(surface(interface.first), surface(interface.second), same_point);
    const double area = shared.area, gap = std::max(interface.gap, shared.gap);
    result.non_matching.push_back(
        {model.label(interface.first), model.label(interface.second), area, shared.area_error, gap});
    result.largest_gap = std::max(result.largest_gap, gap);
    for (BoundaryFaceReport& face : result.boundary_faces)
      if (face.face == interface.first || face.face == interface.second) face.area -= area;
  }
}

bool ModelReport::certified() const {
  return std::all_of(patches.begin(), patches.end(),
                     [](const PatchReport& patch) { return patch.certificate.accepted(); });
}

ModelReport report(const MultiPatch& model, const Progress& progress) {
  ModelReport result;
  for (int i = 0; i < model.patch_count(); ++i) {
    progress("checking the patches", static_cast<double>(i) / model.patch_count());
    result.patches.push_back(report_patch(model, i, progress));
    const PatchReport& patch = result.patches.back();
    result.volume += patch.volume;
    result.control_points += model.patch(PatchId(i)).size();
    result.elements += static_cast<std::int64_t>(patch.elements[0]) * patch.elements[1] * patch.elements[2];
  }
  for (const auto& face : model.boundary_faces()) result.boundary_faces.push_back(report_face(model, face));
  for (const auto& interface : model.interfaces())
    result.largest_gap = std::max(result.largest_gap, interface.gap);
  add_non_matching(model, result);
  for (const BoundaryFaceReport& face : result.boundary_faces) result.boundary_area += face.area;
  result.bodies = model.bodies();
  result.box = geometry::part_box(model);
  progress("checking the patches", 1);
  return result;
}

std::string contents_text(const MultiPatch& model, const ModelReport& report) {
  const std::size_t apart = report.non_matching.size();
  return fmt::format("{}, {}, {}{}, {}", counted(model.patch_count(), "patch", "patches"),
                     counted(model.interfaces().size(), "interface"),
                     apart == 0 ? "" : fmt::format("{} that do{} not match, ", apart, apart == 1 ? "es" : ""),
                     counted(model.boundary_faces().size(), "boundary face"),
                     report.bodies.size() == 1 ? "one body" : fmt::format("{} bodies", report.bodies.size()));
}

namespace {

/// Where integrals between patches, or what lies between these, would be seen in results.
std::vector<Warning> shared_surface_warnings(const ModelReport& report) {
  constexpr double area_share = 1e-4, width_share = 1e-3;
  std::vector<Warning> warnings;
  for (const NonMatchingReport& pair : report.non_matching) {
    if (pair.area_error > area_share * pair.area)
      warnings.push_back(
          {fmt::format("what faces {} and {} share is integrated to {:.1g} of it only; more "
                       "elements on their patches help",
                       pair.first, pair.second, pair.area_error / pair.area)});
    if (pair.gap > width_share * std::sqrt(pair.area))
      warnings.push_back(
          {fmt::format("faces {} and {} are {} apart where they meet, {:.1g} of their width", pair.first,
                       pair.second, with_unit(pair.gap, "m"), pair.gap / std::sqrt(pair.area))});
  }
  return warnings;
}

}  // namespace

std::vector<Warning> certificate_warnings(const MultiPatch& model, const ModelReport& report) {
  std::vector<Warning> warnings = shared_surface_warnings(report);
  for (std::size_t i = 0; i < report.patches.size(); ++i) {
    const auto& certificate = report.patches[i].certificate;
    if (certificate.accepted()) continue;
    const PatchId id(static_cast<int>(i));
    const auto parameter = model.to_input(id, certificate.parameter);
    const std::string place = fmt::format("at parameter {}, {}", place_text(parameter, 4),
                                          place_with_unit(certificate.place, model.size()));
    std::string text =
        certificate.sign == JacobianSign::negative
            ? fmt::format(
                  "patch {} is folded {}: its Jacobian determinant is {:.3g} m^3 there. {}", i, place,
                  certificate.smallest,
                  report.patches[i].quality.min_jacobian > 0
                      ? "All Gauss points are positive, so the study runs; do not trust stresses near "
                        "that place"
                      : "Gauss points are negative too, so no study can run; repair the patch: move its "
                        "inner control points, or split it")
            : fmt::format(
                  "patch {} could not be certified: its Jacobian determinant comes down to {:.3g} m^3 {}", i,
                  certificate.smallest, place);
    warnings.push_back({std::move(text), id.value, certificate.place});
  }
  return warnings;
}

}  // namespace isopatch::app
