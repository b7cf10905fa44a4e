#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::verification {

/// Forces that multipliers exert on the nodes, all patches one after the other. (3, nodes), N
Eigen::Matrix3Xd node_forces(const iga::ElasticityProblem& problem,
                             const std::vector<iga::Multiplier>& multipliers);

/// A force and its moment about the origin.
struct Resultant {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
};

/// Of forces on the nodes of some patches. Rotations have the control points' own displacements as
/// coefficients, so the moment is exact.
Resultant resultant(const iga::ElasticityProblem& problem, const Eigen::Matrix3Xd& forces,
                    const std::vector<PatchId>& patches);

/// Patches of which no node is held, not even through a neighbour.
std::vector<int> untouched_patches(const iga::ElasticityProblem& problem);

/// An interface without which a body falls into two pieces, one of which no support touches.
struct Cut {
  std::string first_label;  ///< "3:north"
  std::string second_label;
  std::vector<PatchId> beyond;  ///< the piece without support
};
std::vector<Cut> cuts_of(const iga::ElasticityProblem& problem);

/// Largest difference of displacements between nodes of one global node, relative to the largest
/// displacement.
double largest_jump(const iga::ElasticityProblem& problem, const iga::ElasticitySolution& solution);

/// Largest difference of two lists for the same pairs of nodes, relative to the largest force of the first;
/// NaN if the pairs differ or there are none.
double multiplier_difference(const std::vector<iga::Multiplier>& a, const std::vector<iga::Multiplier>& b);

}  // namespace isopatch::verification
