#pragma once

#include <vector>

#include "geometry/models/box.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/problem.hpp"

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

}  // namespace isopatch::iga::testing
