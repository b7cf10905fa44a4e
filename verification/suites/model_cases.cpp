#include "verification/suites/model_cases.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <variant>

#include "app/study/generated_models.hpp"
#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {

const std::vector<ModelCase>& model_cases() {
  static const std::vector<ModelCase> cases = {
      {"distorted box",
       {"model.generate=box", "model.patches=[2, 2, 2]", "model.distortion=0.3", "model.curvature=0.2",
        "model.orientation_seed=7"},
       "x_min",
       "x_max"},
      {"ring",
       {"model.generate=cylinder", "model.angle=360 deg", "model.radial_patches=2", "model.axial_patches=2"},
       "bottom",
       "top"},
      {"sphere", {"model.generate=sphere", "model.radial_patches=2"}, "inner", "outer"},
      {"plate", {"model.generate=plate"}, "x_min", "x_max"},
      {"bracket", {"model.generate=bracket"}, "y_max", "x_max"},
      // Ten thick, because bending the classic one out of its plane has a condition number of 2e8.
      {"Cook's membrane",
       {"model.generate=cook", "model.patches=[2, 2]", "model.thickness=10"},
       "x_min",
       "x_max"},
      {"elliptic plate", {"model.generate=elliptic_plate", "model.layers=2"}, "bottom", "top"},
      {"link", {"model.generate=link"}, "bore_left", "bore_right"},
      {"elbow", {"model.generate=elbow"}, "inlet", "outlet"}};
  return cases;
}

const std::vector<ModelCase>& every_model_case() {
  static const std::vector<ModelCase> cases = [] {
    std::vector<ModelCase> all = model_cases();
    all.push_back({"twisted beam", {"model.generate=twisted_beam"}, "root", "tip"});
    return all;
  }();
  return cases;
}

const ModelCase& model_case(const std::string& name) {
  for (const ModelCase& model : every_model_case())
    if (model.name == name) return model;
  throw std::out_of_range("no model " + name);
}

std::vector<std::string> pulled_overrides(const ModelCase& model) {
  std::vector<std::string> result = model.overrides;
  result.push_back(fmt::format("support.0.faces=[\"{}\"]", model.held));
  result.push_back(fmt::format("load.0.faces=[\"{}\"]", model.loaded));
  return result;
}

geometry::PatchSet patches_of(const ModelCase& model) {
  const app::Study study = app::read_study(
      std::filesystem::path(ISOPATCH_SOURCE_DIR) / "verification/studies/pulled.toml", model.overrides);
  return app::generated_patches(std::get<app::GeneratedInput>(study.model.source).dimensions);
}

std::vector<geometry::PatchFace> faces_of(const geometry::MultiPatch& model, const std::string& boundary) {
  for (const geometry::Boundary& b : model.boundaries())
    if (b.name == boundary) return b.faces;
  throw std::out_of_range("no boundary " + boundary);
}

std::vector<PatchId> all_patches(const geometry::MultiPatch& model) {
  std::vector<PatchId> result;
  for (int i = 0; i < model.patch_count(); ++i) result.emplace_back(i);
  return result;
}

}  // namespace isopatch::verification
