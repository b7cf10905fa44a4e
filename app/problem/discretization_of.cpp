#include "app/problem/discretization_of.hpp"

#include <fmt/format.h>

#include "app/problem/selection.hpp"

namespace isopatch::app {
namespace {

bool is_less(const std::array<int, 3>& own, const std::array<int, 3>& of_all) {
  for (std::size_t d = 0; d < 3; ++d)
    if (own[d] > 0 && own[d] < of_all[d]) return true;
  return false;
}

}  // namespace

iga::DiscretizationOptions discretization_of(const Study& study, const geometry::MultiPatch& model) {
  iga::DiscretizationOptions options = study.discretization;
  for (const PatchDiscretizationInput& input : study.patch_discretizations) {
    options.patches.push_back(input.refinement);
    for (const PatchId patch : select_patches(model, input.patches))
      options.patches.back().patches.push_back(patch.value);
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
