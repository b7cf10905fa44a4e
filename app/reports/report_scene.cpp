#include "app/reports/report_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "app/base/engineering_units.hpp"
#include "app/base/internal/json_values.hpp"
#include "app/problem/largest_values.hpp"
#include "iga/post/stress_points.hpp"

namespace isopatch::app {
namespace {

const Json& at(const Json& json, const char* path) {
  static const Json nothing;
  const Json::json_pointer pointer(path);
  return json.is_structured() && json.contains(pointer) ? json[pointer] : nothing;
}

Eigen::Vector3d vector_of(const Json& json) {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  if (json.is_array() && json.size() == 3)
    for (std::size_t i = 0; i < 3; ++i)
      if (json[i].is_number()) result[static_cast<Eigen::Index>(i)] = json[i].get<double>();
  return result;
}

std::vector<ScenePatch> patches_of(const geometry::MultiPatch& model, const iga::PartSamples& samples) {
  std::vector<ScenePatch> result;
  for (int p = 0; p < model.patch_count(); ++p) {
    ScenePatch patch{fmt::format("{}", p), {}, samples.patches[static_cast<std::size_t>(p)].parameters};
    for (const geometry::Side side : geometry::all_sides)
      patch.faces[static_cast<std::size_t>(side)] = model.label({PatchId(p), side});
    for (double& first : patch.parameters[0]) first = model.to_input(PatchId(p), {first, 0, 0})[0];
    result.push_back(std::move(patch));
  }
  return result;
}

// A stress that all but one sample in a hundred stay below: a folded corner must not choose the unit.
double usual_stress(const iga::PartSamples& samples) {
  std::vector<double> all;
  for (const iga::PatchSamples& patch : samples.patches)
    all.insert(all.end(), patch.von_mises.begin(), patch.von_mises.end());
  const auto high = all.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), high, all.end());
  return *high;
}

// The stresses of a patch as the run counts them: none where the map is folded, and none above its largest
// one, which finer samples may exceed by a little.
Eigen::RowVectorXd counted_stresses(const iga::PatchSamples& patch, std::optional<double> largest) {
  Eigen::RowVectorXd result = patch.von_mises.transpose();
  if (!largest) return result;
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const double jacobian = patch.scaled_jacobian[i];
    const bool collapsed = jacobian == 0;
    result[i] = jacobian >= iga::least_scaled_jacobian || collapsed
                    ? std::min(result[i], *largest)
                    : std::numeric_limits<double>::quiet_NaN();
  }
  return result;
}

std::vector<SceneField> fields_of(const iga::PartSamples& samples, std::optional<double> largest) {
  double displacement = 0;
  SceneField u{"displacement", "Displacement", {}, "", {}};
  SceneField mises{"von_mises", "Von Mises stress", {}, "", {}};
  SceneField quality{"scaled_jacobian", "Scaled Jacobian", {"", 1}, "", {}};
  for (const iga::PatchSamples& patch : samples.patches) {
    displacement = std::max(displacement, patch.displacements.colwise().norm().maxCoeff());
    u.values.emplace_back(patch.displacements);
    mises.values.emplace_back(counted_stresses(patch, largest));
    quality.values.emplace_back(patch.scaled_jacobian.transpose());
  }
  u.unit = display_unit(displacement, "m");
  mises.unit = display_unit(usual_stress(samples), "Pa");
  return {u, mises, quality};
}

std::vector<SceneRegion> regions_of(const Json& regions) {
  std::vector<SceneRegion> result;
  if (!regions.is_array()) return result;
  for (const Json& region : regions) {
    result.push_back(
        {region.value("name", ""), region.value("kind", ""), {}, vector_of(at(region, "/total"))});
    for (const Json& face : at(region, "/faces"))
      if (face.is_string()) result.back().faces.push_back(face);
  }
  return result;
}

void add_reactions(std::vector<SceneRegion>& supports, const Json& reactions) {
  for (const Json& reaction : reactions)
    for (SceneRegion& support : supports)
      if (support.name == reaction.value("support", "")) support.force = vector_of(at(reaction, "/force"));
}

// A point's values from the coefficients: those of the summary, to the last digit.
void add_marker(const iga::ElasticField& field, const geometry::MultiPatch& model, const std::string& name,
                const std::string& kind, const Json& place, std::vector<SceneMarker>& markers) {
  const Json& patch = at(place, "/patch");
  if (!patch.is_number_integer()) return;
  const int index = patch.get<int>();
  if (index < 0 || index >= model.patch_count()) return;
  const geometry::Parameter<3> parameter = vector_of(at(place, "/parameter"));
  const iga::FieldValues values = iga::evaluate(field, index, model.from_input(PatchId(index), parameter));
  markers.push_back({name, kind, index, parameter, values.place, values.displacement, values.von_mises});
}

std::vector<SceneMarker> markers_of(const iga::ElasticField& field, const geometry::MultiPatch& model,
                                    const Json& summary) {
  std::vector<SceneMarker> markers;
  add_marker(field, model, "largest displacement", "max_displacement",
             at(summary, "/results/max_displacement_at"), markers);
  add_marker(field, model, "largest von Mises stress", "max_von_mises",
             at(summary, "/results/max_von_mises_at"), markers);
  for (const Json& probe : at(summary, "/probes"))
    add_marker(field, model, probe.value("name", "probe"), "probe", probe, markers);
  return markers;
}

std::vector<SceneWarning> warnings_of(const Json& summary) {
  std::vector<SceneWarning> result;
  const Json& places = at(summary, "/warning_places");
  for (const Json& text : at(summary, "/warnings")) {
    SceneWarning warning{text.is_string() ? text.get<std::string>() : "", {}, {}};
    if (places.is_array() && result.size() < places.size()) {
      const Json& place = places[result.size()];
      if (at(place, "/patch").is_number_integer()) warning.patch = at(place, "/patch").get<int>();
      if (at(place, "/point").is_array()) warning.place = vector_of(at(place, "/point"));
    }
    result.push_back(std::move(warning));
  }
  return result;
}

}  // namespace

Scene report_scene(const iga::ElasticField& field, const geometry::MultiPatch& model,
                   const std::string& summary, const iga::SamplingOptions& sampling) {
  const Json json = Json::parse(summary, nullptr, false);
  Scene scene;
  scene.model = &model;
  scene.sampling = sampling;
  scene.samples = iga::sample_part(model, field, sampling);
  scene.patches = patches_of(model, scene.samples);
  scene.length = model_length_unit(model.size());
  scene.fields = fields_of(scene.samples, largest_values(summary).von_mises);
  if (json.is_discarded()) return scene;
  scene.supports = regions_of(at(json, "/supports"));
  add_reactions(scene.supports, at(json, "/results/reactions"));
  scene.loads = regions_of(at(json, "/loads"));
  scene.markers = markers_of(field, model, json);
  scene.warnings = warnings_of(json);
  return scene;
}

}  // namespace isopatch::app
