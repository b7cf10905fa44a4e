#include "app/problem/discretization_of.hpp"

#include "app/problem/selection.hpp"

namespace isopatch::app {

iga::DiscretizationOptions discretization_of(const Study& study, const geometry::MultiPatch& model) {
  iga::DiscretizationOptions options = study.discretization;
  for (const PatchDiscretizationInput& input : study.patch_discretizations) {
    options.patches.push_back(input.refinement);
    for (const PatchId patch : select_patches(model, input.patches))
      options.patches.back().patches.push_back(patch.value);
  }
  return options;
}

}  // namespace isopatch::app
