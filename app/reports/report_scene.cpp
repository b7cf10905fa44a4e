#include "app/reports/report_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "app/base/engineering_units.hpp"
#include "geometry/base/larger.hpp"
#include "iga/post/stress_points.hpp"

namespace isopatch::app {
namespace {

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

// 0 at points that count, not a number where the map is folded.
Eigen::RowVectorXd sound_points(const iga::PatchSamples& patch) {
  Eigen::RowVectorXd result = Eigen::RowVectorXd::Zero(patch.scaled_jacobian.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const double jacobian = patch.scaled_jacobian[i];
    if (jacobian < iga::least_scaled_jacobian && jacobian != 0)
      result[i] = std::numeric_limits<double>::quiet_NaN();
  }
  return result;
}

std::vector<SceneField> fields_of(const iga::PartSamples& samples, std::optional<double> largest) {
  double displacement = 0;
  SceneField u{"displacement", "Displacement", {}, "", {}};
  SceneField mises{"von_mises", "Von Mises stress", {}, "", {}};
  SceneField components{"stress", "Stress", {}, "", {}, true};
  SceneField tension{"max_principal", "Largest principal stress", {}, "", {}};
  SceneField compression{"min_principal", "Smallest principal stress", {}, "", {}};
  SceneField shear{"tresca", "Tresca stress", {}, "", {}};
  SceneField quality{"scaled_jacobian", "Scaled Jacobian", {"", 1}, "", {}};
  for (const iga::PatchSamples& patch : samples.patches) {
    displacement = std::max(displacement, patch.displacements.colwise().norm().maxCoeff());
    u.values.emplace_back(patch.displacements);
    mises.values.emplace_back(counted_stresses(patch, largest));
    const Eigen::RowVectorXd sound = sound_points(patch);
    components.values.emplace_back(patch.stress + Eigen::VectorXd::Ones(6) * sound);
    tension.values.emplace_back(patch.principal.row(0) + sound);
    compression.values.emplace_back(patch.principal.row(2) + sound);
    shear.values.emplace_back(patch.principal.row(0) - patch.principal.row(2) + sound);
    quality.values.emplace_back(patch.scaled_jacobian.transpose());
  }
  u.unit = display_unit(displacement, "m");
  mises.unit = display_unit(usual_stress(samples), "Pa");
  components.unit = tension.unit = compression.unit = shear.unit = mises.unit;
  return {u, mises, components, tension, compression, shear, quality};
}

// The estimated error of the element that each sample lies in: of samples between elements the larger one.
Eigen::RowVectorXd errors_at(const iga::PatchSamples& samples, const geometry::NurbsVolume& patch,
                             const Eigen::VectorXd& of_elements) {
  std::array<std::vector<std::array<Eigen::Index, 2>>, 3> elements;  // before and behind each parameter
  for (std::size_t d = 0; d < 3; ++d) {
    const std::vector<double> breaks = patch.knots()[d].breaks();
    const auto last = static_cast<Eigen::Index>(breaks.size()) - 2;
    const double nearly = 1e-9 * patch.knots()[d].length();
    const auto element = [&](double t) {
      const auto after = std::upper_bound(breaks.begin(), breaks.end(), t) - breaks.begin();
      return std::clamp<Eigen::Index>(after - 1, 0, last);
    };
    for (const double t : samples.parameters[d])
      elements[d].push_back({element(t - nearly), element(t + nearly)});
  }
  const Eigen::Index m = patch.knots(0).element_count(), n = patch.knots(1).element_count();
  Eigen::RowVectorXd result(samples.points.cols());
  Eigen::Index at = 0;
  for (const auto& w : elements[2])
    for (const auto& v : elements[1])
      for (const auto& u : elements[0]) {
        double largest = 0;
        for (const Eigen::Index k : w)
          for (const Eigen::Index j : v)
            for (const Eigen::Index i : u) largest = larger(largest, of_elements[i + m * (j + n * k)]);
        result[at++] = largest;
      }
  return result;
}

void add_errors(const iga::ElasticField& field, const iga::PartSamples& samples,
                std::vector<SceneField>& fields) {
  if (field.errors.empty()) return;
  SceneField error{"stress_error", "Stress error", {}, "", {}};
  double most = 0;
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    error.values.emplace_back(errors_at(samples.patches[p], field.patches[p], field.errors[p].stress));
    most = larger(most, error.values.back().maxCoeff<Eigen::PropagateNaN>());
  }
  error.unit = display_unit(most, "Pa");
  fields.push_back(std::move(error));
}

std::vector<SceneRegion> scene_regions(const std::vector<SummarizedRegion>& regions) {
  std::vector<SceneRegion> result;
  for (const SummarizedRegion& region : regions)
    result.push_back({region.name, region.kind, region.faces, region.force});
  return result;
}

// A point's values from the coefficients: those of the summary, to the last digit.
void add_marker(const iga::ElasticField& field, const geometry::MultiPatch& model, const std::string& name,
                const std::string& kind, const std::optional<SummarizedPlace>& place,
                std::vector<SceneMarker>& markers) {
  if (!place || place->patch < 0 || place->patch >= model.patch_count()) return;
  const geometry::Parameter<3> parameter = place->parameter;
  const iga::FieldValues values =
      iga::evaluate(field, place->patch, model.from_input(PatchId(place->patch), parameter));
  markers.push_back(
      {name, kind, place->patch, parameter, values.place, values.displacement, values.von_mises});
}

std::vector<SceneMarker> markers_of(const iga::ElasticField& field, const geometry::MultiPatch& model,
                                    const RunSummary& summary) {
  std::vector<SceneMarker> markers;
  add_marker(field, model, "largest displacement", "max_displacement", summary.max_displacement_at, markers);
  add_marker(field, model, "largest von Mises stress", "max_von_mises", summary.max_von_mises_at, markers);
  for (const SummarizedPlace& probe : summary.probes)
    add_marker(field, model, probe.name, "probe", probe, markers);
  return markers;
}

}  // namespace

Scene report_scene(const iga::ElasticField& field, const geometry::MultiPatch& model,
                   const RunSummary& summary, const iga::SamplingOptions& sampling) {
  Scene scene;
  scene.model = &model;
  scene.sampling = sampling;
  scene.samples = iga::sample_part(model, field, sampling);
  scene.patches = patches_of(model, scene.samples);
  scene.length = model_length_unit(model.size());
  scene.fields = fields_of(scene.samples, summary.largest_von_mises());
  add_errors(field, scene.samples, scene.fields);
  scene.supports = scene_regions(summary.supports);
  scene.loads = scene_regions(summary.loads);
  scene.markers = markers_of(field, model, summary);
  for (const Warning& warning : summary.warnings)
    scene.warnings.push_back({warning.text, warning.patch, warning.place});
  return scene;
}

}  // namespace isopatch::app
