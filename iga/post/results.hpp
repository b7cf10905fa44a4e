#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/coupling/support_frames.hpp"
#include "iga/post/elasticity_results.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/processes.hpp"

namespace isopatch::iga {

/// The largest displacement on a grid of degree + 1 points per element and direction, ends included.
/// @cost  O((degree + 1)^4) per element; no memory that grows with the elements
Extremum max_displacement(const ElasticField& field);
/// The same over the elements of some parts; a value of -1 in no patch if there are none.
Extremum max_displacement(const ElasticField& field, const std::vector<PatchLayers>& parts);

/// Force and moment of every support on the part, from the residual K u - f of the fixed components.
/// @param forces  internal forces minus loads per node, (3, nodes), N
std::vector<Reaction> support_reactions(const ElasticityProblem& problem, const GlobalNodes& global,
                                        const std::vector<SupportFrame>& frames,
                                        const Eigen::Matrix3Xd& forces);

}  // namespace isopatch::iga
