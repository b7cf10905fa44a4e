#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "iga/spaces/patch_samples.hpp"

namespace isopatch::iga {

/// Samples of all patches. Where two patches meet both have the same points, so surfaces made of them have no
/// cracks.
struct PartSamples {
  std::vector<PatchSamples> patches;
  bool is_coarse = false;  ///< whether `most_points` kept the grid from reaching the tolerances
};

/// Samples a part with or without a solution, adaptively: each element is cut into as many pieces per
/// direction as its curvature and that of the fields ask for.
///
/// @param model    how the patches meet; its patches' knots may be coarser than the field's
/// @param patches  the geometry, in any space that contains the model's
/// @cost   O(degree) per sample and field
PartSamples sample_part(const geometry::MultiPatch& model, const std::vector<geometry::NurbsVolume>& patches,
                        const SamplingOptions& options = {});
PartSamples sample_part(const geometry::MultiPatch& model, const ElasticField& field,
                        const SamplingOptions& options = {});

}  // namespace isopatch::iga
