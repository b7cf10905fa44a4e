#pragma once

#include <vector>

#include "iga/assembly/interface_stiffness.hpp"
#include "iga/assembly/mortar_constraints.hpp"
#include "iga/assembly/node_blocks.hpp"
#include "iga/problem/springs.hpp"

namespace isopatch::iga {

/// All that adds to the stiffness of a part on its surfaces and between its patches.
struct SurfaceTerms {
  Springs springs;
  std::vector<CoupledFaces> interfaces;  ///< that do not match
  std::vector<Material> materials;       ///< one per patch
  double same_point = 0;                 ///< m
  MortarTies mortar;                     ///< tied by `mortar_stiffness`, in preconditioners
};
SurfaceTerms surface_terms(const ElasticityProblem& problem);

/// Their blocks for any spaces on the patches; shares of all processes add up.
/// @param parts  what this process integrates
NodeBlocks surface_stiffness(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                             const SurfaceTerms& terms);

/// The interfaces among the terms that this process integrates.
std::vector<CoupledFaces> interfaces_of(const SurfaceTerms& terms, const std::vector<PatchLayers>& parts);

/// Nitsche's terms alone.
NodeBlocks interface_stiffness(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                               const SurfaceTerms& terms);

}  // namespace isopatch::iga
