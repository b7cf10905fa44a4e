#pragma once

#include <array>
#include <vector>

#include "iga/spaces/elastic_field.hpp"
#include "iga/spaces/patch_samples.hpp"

namespace isopatch::iga {

/// A patch to sample, with its field if there is one.
struct SampledPatch {
  const geometry::NurbsVolume* patch = nullptr;
  const ElasticField* field = nullptr;  ///< none: geometry only
  int index = 0;                        ///< of the patch in the field
};

/// Evaluates geometry and fields at the points of a grid of parameters, direction by direction.
///
/// Where the map is singular, stresses are those of `evaluate`. `element_ends` stays empty.
/// @cost  O(functions per direction) per point and component, as products of dense matrices
PatchSamples fields_on_grid(const SampledPatch& sampled,
                            const std::array<std::vector<double>, 3>& parameters);

}  // namespace isopatch::iga
