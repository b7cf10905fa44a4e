#include "app/reports/parameterization_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "app/base/engineering_units.hpp"
#include "app/base/internal/json_values.hpp"
#include "app/base/provenance.hpp"
#include "app/pages/page.hpp"
#include "app/problem/model_report.hpp"
#include "app/results/internal/parameterization_json.hpp"

namespace isopatch::app {
namespace {

using geometry::HexFaceUse;
using segmentation::FaceReport;
using segmentation::ParameterizationReport;

double share(const std::vector<double>& parameters, int index) {
  const double low = parameters.front(), high = parameters.back();
  return (parameters[static_cast<std::size_t>(index)] - low) / (high - low);
}

/// The largest of what was there and the deviation, at all samples of one side of a patch.
void add_side(const iga::PatchSamples& samples, const FaceReport& face, const HexFaceUse& use,
              Eigen::MatrixXd& values) {
  const auto n = samples.sizes();
  const auto across = static_cast<std::size_t>(geometry::direction(use.side.side));
  const auto along = geometry::tangents(use.side.side);
  const auto a = static_cast<std::size_t>(along[0]), b = static_cast<std::size_t>(along[1]);
  const geometry::FaceOrientation to_face = geometry::inverse(use.orientation);
  std::array<int, 3> at{};
  at[across] = geometry::is_high(use.side.side) ? n[across] - 1 : 0;
  for (at[b] = 0; at[b] < n[b]; ++at[b])
    for (at[a] = 0; at[a] < n[a]; ++at[a]) {
      const geometry::Parameter<2> place = to_face(
          geometry::Parameter<2>(share(samples.parameters[a], at[a]), share(samples.parameters[b], at[b])));
      double& value = values(0, at[0] + n[0] * (at[1] + n[1] * at[2]));
      value = std::fmax(value, face.deviations.at(place[0], place[1]));
    }
}

std::vector<ScenePatch> patches_of(const ParameterizationReport& report, const geometry::MultiPatch& model,
                                   const iga::PartSamples& samples) {
  std::vector<ScenePatch> result;
  for (int p = 0; p < model.patch_count(); ++p) {
    const auto i = static_cast<std::size_t>(p);
    ScenePatch patch{report.patches[i].name, {}, samples.patches[i].parameters};
    for (const geometry::Side side : geometry::all_sides)
      patch.faces[static_cast<std::size_t>(side)] = model.label({PatchId(p), side});
    result.push_back(std::move(patch));
  }
  return result;
}

SceneField scaled_jacobian(const iga::PartSamples& samples) {
  SceneField field{"scaled_jacobian", "Scaled Jacobian", {"", 1}, "", {}};
  for (const iga::PatchSamples& patch : samples.patches)
    field.values.emplace_back(patch.scaled_jacobian.transpose());
  return field;
}

/// Those of patches come first, then those of faces.
std::vector<SceneWarning> warnings_of(const ParameterizationReport& report) {
  std::vector<SceneWarning> result;
  for (const std::string& text : report.complaints()) result.push_back({text, {}, {}});
  std::size_t next = 0;
  for (std::size_t p = 0; p < report.patches.size(); ++p) {
    const auto& patch = report.patches[p];
    if (patch.certificate.accepted()) continue;
    result[next].patch = static_cast<int>(p);
    result[next].place = patch.folded_edge ? patch.folded_edge->place : patch.certificate.place;
    ++next;
  }
  return result;
}

Json model_json(const geometry::MultiPatch& model, const ModelReport& seen) {
  double worst = 1;
  for (const PatchReport& patch : seen.patches) worst = std::min(worst, patch.quality.min_scaled_jacobian);
  return {{"patches", model.patch_count()},
          {"interfaces", model.interfaces().size()},
          {"boundary_faces", model.boundary_faces().size()},
          {"volume", seen.volume},
          {"boundary_area", seen.boundary_area},
          {"box",
           {{"min", to_json(Eigen::Vector3d(seen.box.min()))},
            {"max", to_json(Eigen::Vector3d(seen.box.max()))}}},
          {"min_scaled_jacobian", worst}};
}

}  // namespace

std::vector<SceneField> parameterization_fields(const ParameterizationReport& report,
                                                const iga::PartSamples& samples) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  SceneField deviation{
      "deviation", "Deviation from the solid", display_unit(report.worst_face().deviation, "m"), "", {}};
  SceneField bound{"determinant_bound", "Certified bound of det J over its mean", {"", 1}, "", {}};
  for (std::size_t p = 0; p < samples.patches.size(); ++p) {
    const Eigen::Index count = samples.patches[p].points.cols();
    const bool known = p < report.patches.size();  // others are attached
    deviation.values.emplace_back(Eigen::MatrixXd::Constant(1, count, none));
    bound.values.emplace_back(Eigen::MatrixXd::Constant(
        1, count, known ? report.patches[p].certificate.lower / report.patches[p].volume : none));
  }
  for (const FaceReport& face : report.faces)
    for (const HexFaceUse& use : face.uses) {
      const auto p = static_cast<std::size_t>(use.side.block.value);
      add_side(samples.patches[p], face, use, deviation.values[p]);
    }
  return {deviation, bound};
}

std::string parameterization_html(const ParameterizationReport& report, const geometry::MultiPatch& model,
                                  const std::string& title) {
  Scene scene;
  scene.model = &model;
  scene.samples = iga::sample_part(model, model.patches(), scene.sampling);
  scene.patches = patches_of(report, model, scene.samples);
  scene.length = model_length_unit(model.size());
  scene.fields = parameterization_fields(report, scene.samples);
  scene.fields.insert(scene.fields.begin(), scaled_jacobian(scene.samples));
  scene.warnings = warnings_of(report);
  const Json summary = {{"model", model_json(model, app::report(model))},
                        {"parameterization", parameterization_json(report)},
                        {"warnings", report.complaints()}};
  Page page;
  page.kind = "model";
  page.program = fmt::format("isopatch {}", version());
  page.title = title;
  page.summary_json = summary.dump(-1, ' ', false, Json::error_handler_t::replace);
  page.scene = std::move(scene);
  return to_html(page);
}

}  // namespace isopatch::app
