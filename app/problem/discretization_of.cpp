#include "app/problem/discretization_of.hpp"

#include <fmt/format.h>

#include "app/problem/face_part.hpp"
#include "app/problem/selection.hpp"

namespace isopatch::app {
namespace {

bool is_less(const std::array<int, 3>& own, const std::array<int, 3>& of_all) {
  for (std::size_t d = 0; d < 3; ++d)
    if (own[d] > 0 && own[d] < of_all[d]) return true;
  return false;
}

// Whether one of 9 x 9 x 9 points of a patch lies in a region.
bool reaches_into(const iga::Region& region, const geometry::NurbsVolume& patch) {
  constexpr int samples = 9;
  for (int k = 0; k < samples; ++k)
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i) {
        const geometry::Parameter<3> share(i / (samples - 1.0), j / (samples - 1.0), k / (samples - 1.0));
        if (region.contains(patch.point(patch.low() + (patch.high() - patch.low()).cwiseProduct(share))))
          return true;
      }
  return false;
}

std::vector<int> patches_of(const PatchDiscretizationInput& input, const geometry::MultiPatch& model) {
  const iga::Region region = part_of(input.reach);
  std::vector<int> result;
  for (const PatchId patch : select_patches(model, input.patches))
    if (region.is_everywhere() || reaches_into(region, model.patch(patch))) result.push_back(patch.value);
  if (result.empty())
    throw error_at(input.place,
                   "no patch reaches into the part of [[discretization.patch]]; is it in the units of the "
                   "study, and where the model is? `isopatch info` gives its box");
  return result;
}

}  // namespace

iga::DiscretizationOptions discretization_of(const Study& study, const geometry::MultiPatch& model) {
  iga::DiscretizationOptions options = study.discretization;
  for (const PatchDiscretizationInput& input : study.patch_discretizations) {
    options.patches.push_back(input.refinement);
    options.patches.back().patches = patches_of(input, model);
  }
  return options;
}

std::vector<Warning> idle_refinement_warnings(const Study& study) {
  std::vector<Warning> warnings;
  const iga::DiscretizationOptions& all = study.discretization;
  for (const PatchDiscretizationInput& input : study.patch_discretizations) {
    const iga::PatchRefinement& own = input.refinement;
    const auto add = [&](const char* key, const char* how) {
      warnings.push_back(
          {fmt::format("{}: {} of [[discretization.patch]] is {} than that of "
                       "[discretization], which holds for all patches: it changes nothing",
                       to_string(input.place), key, how)});
    };
    if (is_less(own.degree, all.degree)) add("degree", "lower");
    if (is_less(own.elements_per_direction, all.elements_per_direction))
      add("elements_per_direction", "lower");
    if (own.max_size > 0 && all.max_size > 0 && own.max_size > all.max_size) add("max_size", "larger");
  }
  return warnings;
}

}  // namespace isopatch::app
