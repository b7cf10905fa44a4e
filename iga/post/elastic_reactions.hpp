#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/post/elasticity_results.hpp"
#include "iga/problem/problem.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/processes.hpp"

namespace isopatch::iga {

/// What elastic supports do to a displaced part.
struct ElasticReactions {
  Eigen::Matrix3Xd forces;  ///< of the part on the springs per node before any coupling, (3, nodes), N
  std::vector<Reaction> reactions;  ///< on the part, one per support of the problem; of other supports 0
  double energy = 0;                ///< in the springs, J
};

/// @param displacement  coefficients per node, (3, nodes), m
/// @param parts         element layers whose faces are integrated: all is additive
ElasticReactions elastic_reactions(const ElasticityProblem& problem, const Eigen::Matrix3Xd& displacement,
                                   const std::vector<PatchSpace>& spaces,
                                   const std::vector<PatchLayers>& parts);

/// Combines the shares of all processes but for `forces`, which stay a share; all get the result.
ElasticReactions summed(ElasticReactions share, const solvers::Processes& processes);

}  // namespace isopatch::iga
