#pragma once

#include <Eigen/Core>

#include "solvers/solve_report.hpp"

namespace isopatch::iga {

/// The coefficients that solve a CoupledProblem, the same on every process.
struct DiscreteSolution {
  Eigen::Matrix3Xd displacement;  ///< coefficients of all nodes of all patches, m
  Eigen::VectorXd multipliers;    ///< one per MultiplierRow, N; empty where they were eliminated
  solvers::SolveReport report;
  Eigen::VectorXd mortar = {};  ///< (rows of the mortar constraints), N
};

}  // namespace isopatch::iga
