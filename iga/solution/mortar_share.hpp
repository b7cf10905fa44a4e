#pragma once

#include <vector>

#include "iga/assembly/mortar_constraints.hpp"
#include "iga/distribution/distribution.hpp"
#include "solvers/processes.hpp"

namespace isopatch::iga {

/// The constraints of the faces whose ties this process computes: all if it is alone.
struct MortarShare {
  MortarConstraints constraints;
  std::vector<int> rows;  ///< of the share, among those of all constraints; increasing
};

/// @param parts  what this process integrates
MortarShare mortar_share(const MortarConstraints& all, const std::vector<PatchLayers>& parts);

/// The process of every row of the constraints.
std::vector<int> processes_of_mortar(const MortarConstraints& all, const Distribution& distribution);

/// The values of all rows, from those of every process' share.
Eigen::VectorXd whole_mortar(const MortarShare& share, const Eigen::VectorXd& values, int all_rows,
                             const solvers::Processes& processes);

}  // namespace isopatch::iga
