#include "app/problem/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/base/engineering_units.hpp"
#include "app/base/place_tolerance.hpp"
#include "app/problem/face_name.hpp"
#include "geometry/base/nearest_name.hpp"
#include "geometry/face_match.hpp"
#include "geometry/measures.hpp"

namespace isopatch::app {
namespace {

using geometry::MultiPatch;
using geometry::PatchFace;

/// Faces that miss the tolerance by less than this were perhaps meant.
constexpr double near_miss_factor = 5;

/// The next number with two digits above x > 0.
double rounded_up(double x) {
  const double digit = std::pow(10, std::floor(std::log10(x)) - 1);
  return digit * (std::floor(x / digit) + 1);
}

bool contains(const std::vector<PatchFace>& faces, const PatchFace& face) {
  return std::find(faces.begin(), faces.end(), face) != faces.end();
}

/// "1:west", or "1:west of \"bore\"" where the study says it so.
std::string as_given(const std::string& label, const std::string& text) {
  return text == label ? label : fmt::format("{} of \"{}\"", label, text);
}

/// "1:west", or "1:west of \"bore\"" where its side has a name of its source, such as that of a solid's face.
std::string with_name(const MultiPatch& model, const PatchFace& face) {
  for (const geometry::Boundary& boundary : model.boundaries())
    if (contains(boundary.faces, face)) return as_given(model.label(face), boundary.name);
  return model.label(face);
}

/// Refuses what is no boundary face, saying what it is.
/// @param text  what the study calls it
void check_boundary(const MultiPatch& model, const PatchFace& face, const std::string& text,
                    const Place& place) {
  if (contains(model.boundary_faces(), face)) return;
  const std::string name = as_given(model.label(face), text);
  for (const auto& interface : model.interfaces()) {
    if (interface.first != face && interface.second != face) continue;
    const PatchFace other = interface.first == face ? interface.second : interface.first;
    throw error_at(place,
                   fmt::format("face {} is no boundary: it is joined to {}", name, model.label(other)));
  }
  for (const auto& interface : model.non_matching()) {
    if (interface.first != face && interface.second != face) continue;
    throw error_at(place,
                   fmt::format("face {} is no boundary: others lie on all of it, among them {}", name,
                               model.label(interface.first == face ? interface.second : interface.first)));
  }
  const geometry::NurbsSurface surface = geometry::face_surface(model.patch(face.patch), face.side);
  const Eigen::Vector3d middle = surface.point(geometry::unscaled(surface, {0.5, 0.5}));
  throw error_at(
      place,
      fmt::format("face {} at {} is collapsed to a curve or a point and has no area: points nearer than {} "
                  "count as one. Choose another face; if this one is narrow, lower model.same_point",
                  name, place_with_unit(middle, model.size()),
                  with_unit(model.tolerance().same_point * model.size(), "m")));
}

/// Boundary faces, as isopatch names them.
std::vector<PatchFace> named_faces(const MultiPatch& model, const std::string& text, const Place& place) {
  auto faces = faces_named(text, model.patch_count(), model.boundaries(), place,
                           [&](const PatchFace& face) { return model.from_input(face); });
  for (const PatchFace& face : faces) check_boundary(model, face, text, place);
  return faces;
}

/// How far a face is from fulfilling the conditions.
struct Deviation {
  PatchFace face;
  double distance = 0;  ///< m
  Angle angle = {};
};

Deviation deviation(const MultiPatch& model, const PatchFace& face, const FaceConditions& where) {
  constexpr int samples = 9;
  const auto& patch = model.patch(face.patch);
  const auto surface = geometry::face_surface(patch, face.side);
  const auto low = surface.low();
  const auto range = (surface.high() - low).eval();
  Deviation result{face, 0, {}};
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const geometry::Parameter<2> ends(i / (samples - 1.0), j / (samples - 1.0));
      result.distance =
          std::max(result.distance, distance(where, surface.point(low + range.cwiseProduct(ends))));
      if (!where.normal) continue;
      // Normals may not exist at collapsed edges, so they are taken inside.
      const geometry::Parameter<2> inside((i + 0.5) / samples, (j + 0.5) / samples);
      const auto normal = geometry::outward_normal(patch, face.side, low + range.cwiseProduct(inside));
      result.angle =
          std::max(result.angle,
                   Angle::radians(std::atan2(normal.cross(*where.normal).norm(), normal.dot(*where.normal))));
    }
  return result;
}

Error nothing_found(const MultiPatch& model, const FaceSelection& selection,
                    std::vector<Deviation> candidates, double tolerance) {
  const auto score = [&](const Deviation& d) {
    return d.distance / tolerance +
           (selection.where->normal ? d.angle.radians() / selection.where->angle.radians() : 0);
  };
  std::sort(candidates.begin(), candidates.end(),
            [&](const auto& a, const auto& b) { return score(a) < score(b); });
  std::string nearest;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, candidates.size()); ++i) {
    nearest += fmt::format("{}{} (up to {} away", i ? ", " : "", model.label(candidates[i].face),
                           with_unit(candidates[i].distance, "m"));
    if (selection.where->normal)
      nearest += fmt::format(", normal {:.1f} deg off", candidates[i].angle.degrees());
    nearest += ")";
  }
  return error_at(
      selection.place,
      fmt::format(
          "the selection matches no face. Nearest: {}; the tolerance is {}. {}. `isopatch info` lists "
          "all faces with their centres and normals",
          nearest, with_unit(tolerance, "m"), listed_boundaries(model.boundaries())));
}

// What acts on a face acts on all of it.
void refuse_partly_covered(const MultiPatch& model, const std::vector<PatchFace>& faces, const Place& place) {
  for (const PatchFace& face : faces)
    if (contains(model.partly_covered(), face))
      throw error_at(place,
                     fmt::format("face {} is covered in part by other patches, and a support or load would "
                                 "act beneath them too; give the place where it acts, beside them, by "
                                 "part = {{ box = {{ min = [...], max = [...] }} }}, or by a plane, cylinder "
                                 "or sphere, or divide the patch along their outline",
                                 with_name(model, face)));
}

}  // namespace

double distance(const FaceConditions& conditions, const Eigen::Vector3d& point) {
  double result = 0;
  if (conditions.plane)
    result = std::max(result, std::abs((point - conditions.plane->point).dot(conditions.plane->normal)));
  if (conditions.cylinder) {
    const Eigen::Vector3d radial = (point - conditions.cylinder->point).cross(conditions.cylinder->axis);
    result = std::max(result, std::abs(radial.norm() - conditions.cylinder->radius));
  }
  if (conditions.sphere)
    result =
        std::max(result, std::abs((point - conditions.sphere->centre).norm() - conditions.sphere->radius));
  if (conditions.box) {
    const Eigen::Vector3d outside =
        (conditions.box->min - point).cwiseMax(point - conditions.box->max).cwiseMax(0);
    result = std::max(result, outside.norm());
  }
  return result;
}

SelectedFaces select_faces(const MultiPatch& model, const FaceSelection& selection) {
  std::vector<PatchFace> faces = model.boundary_faces();
  if (!selection.faces.empty()) {
    faces.clear();
    for (const std::string& text : selection.faces) {
      const auto more = named_faces(model, text, selection.place);
      faces.insert(faces.end(), more.begin(), more.end());
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  if (!selection.where) {
    if (!selection.part) refuse_partly_covered(model, faces, selection.place);
    return {faces};
  }
  const double tolerance = selection.where->tolerance.value_or(place_tolerance * model.size());
  SelectedFaces result;
  result.tolerance = tolerance;
  std::vector<Deviation> candidates;
  for (const PatchFace& face : faces) {
    candidates.push_back(deviation(model, face, *selection.where));
    const bool turned = selection.where->normal && candidates.back().angle > selection.where->angle;
    const double distance = candidates.back().distance;
    if (turned || distance >= near_miss_factor * tolerance) continue;
    if (distance <= tolerance)
      result.faces.push_back(face);
    else
      result.near_misses.push_back({face, distance});
  }
  if (result.faces.empty()) throw nothing_found(model, selection, std::move(candidates), tolerance);
  std::stable_sort(result.near_misses.begin(), result.near_misses.end(),
                   [](const NearMiss& a, const NearMiss& b) { return a.distance < b.distance; });
  if (!selection.part) refuse_partly_covered(model, result.faces, selection.place);
  return result;
}

std::string near_miss_warning(const MultiPatch& model, const FaceSelection& selection,
                              const std::string& name, const SelectedFaces& selected) {
  if (selected.near_misses.empty()) return "";
  std::string faces;
  for (const NearMiss& miss : selected.near_misses)
    faces += fmt::format("{}{} (up to {} away)", faces.empty() ? "" : ", ", model.label(miss.face),
                         with_unit(miss.distance, "m"));
  return fmt::format("{}: {} leaves out {}; its tolerance is {}. tolerance = \"{}\" would include them",
                     to_string(selection.place), name, faces, with_unit(selected.tolerance, "m"),
                     with_unit(rounded_up(selected.near_misses.back().distance), "m"));
}

std::vector<PatchId> select_patches(const geometry::MultiPatch& model, const PatchSelection& selection) {
  const int patch_count = model.patch_count();
  std::vector<bool> chosen(static_cast<std::size_t>(patch_count),
                           selection.ranges.empty() && selection.names.empty());
  for (const auto& [first, last] : selection.ranges) {
    if (last >= patch_count)
      throw error_at(selection.place, fmt::format("patch {} does not exist: the model has patches 0 to {}",
                                                  last, patch_count - 1));
    std::fill(chosen.begin() + first, chosen.begin() + last + 1, true);
  }
  std::vector<std::string> known;
  for (int i = 0; i < patch_count; ++i) known.push_back(model.patch_name(PatchId(i)));
  for (const std::string& name : selection.names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      throw error_at(selection.place,
                     fmt::format("no patch is called \"{}\"{}; patches are \"all\", numbers from 0, "
                                 "ranges such as \"0-8\" or names of bodies",
                                 name, did_you_mean(name, known)));
    for (int i = 0; i < patch_count; ++i)
      if (known[static_cast<std::size_t>(i)] == name) chosen[static_cast<std::size_t>(i)] = true;
  }
  std::vector<PatchId> result;
  for (int i = 0; i < patch_count; ++i)
    if (chosen[static_cast<std::size_t>(i)]) result.emplace_back(i);
  return result;
}

}  // namespace isopatch::app
