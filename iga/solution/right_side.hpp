#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/material/thermal_strain.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// The right side of the discrete equations: loads and prescribed displacements, all that differs from one
/// load case to the other.
struct RightSide {
  Eigen::Matrix3Xd load;                ///< per node, those of temperatures included, (3, nodes), N
  Eigen::Matrix3Xd prescribed;          ///< what supports prescribe, per global node, (3, global nodes), m
  std::vector<std::string> idle_loads;  ///< as ElasticityResults has them
  std::vector<ThermalStrain> thermal = {};  ///< one per patch, or none
  Eigen::Matrix3Xd thermal_load = {};       ///< share of `load` that temperatures cause; empty without
  Eigen::Matrix3Xd thermal_ties = {};       ///< the same through Nitsche's terms, not in `thermal_load`
};

/// The right side of a problem's loads and supports, without thermal loads.
/// @param frames  `support_frames` of the problem
RightSide right_side(const ElasticityProblem& problem, const GlobalNodes& global,
                     const std::vector<SupportFrame>& frames, int points);

/// The sum of right sides with factors.
RightSide combined(const std::vector<RightSide>& sides, const std::vector<double>& factors);

}  // namespace isopatch::iga
