#pragma once

#include <string>
#include <vector>

#include "geometry/models/box.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::iga::testing {

/// Faces of a named boundary.
inline std::vector<geometry::PatchFace> boundary(const geometry::MultiPatch& model, const std::string& name) {
  for (const geometry::Boundary& b : model.boundaries())
    if (b.name == name) return b.faces;
  return {};
}

/// Problem with one material everywhere, no supports and no loads.
inline ElasticityProblem problem(const geometry::MultiPatch& model, const DiscretizationOptions& options,
                                 const Material& material) {
  return {discretize(model, options),
          std::vector<Material>(static_cast<std::size_t>(model.patch_count()), material),
          {},
          {},
          {}};
}

/// 2x2x2 distorted and curved patches in random orientations.
inline geometry::MultiPatch distorted_box() {
  return geometry::connect(geometry::box_model(
      {.patches = {2, 2, 2}, .distortion = 0.3, .curvature = 0.2, .orientation_seed = 7}));
}

inline const Material steel = isotropic(210e9, 0.3, 7850, "steel");

}  // namespace isopatch::iga::testing
