#pragma once

#include <vector>

#include "iga/assembly/assembly.hpp"
#include "iga/solution/coupled_problem.hpp"

namespace isopatch::iga {

/// The linear system of a coupled problem with its supports brought in, as `solvers::solve` takes it: the
/// displacement of block row r is prescribed + axes * x in the frame `frame_of_row[r]`.
struct AssembledSystem {
  solvers::LinearSystem system;                   ///< of this process, with the load of the first right side
  std::vector<Eigen::VectorXd> loads;             ///< of this process, one per right side
  std::vector<Eigen::VectorXd> prescribed;        ///< of the whole system's rows, one per right side
  RowNumbering numbering;                         ///< of the whole system
  std::vector<const SupportFrame*> frame_of_row;  ///< of the whole system; into the problem
};

/// Assembles the stiffness matrix, the load and, with multipliers, the constraints: those of `multipliers`,
/// then those of `mortar`.
/// @param coupled  must outlive the result
/// @throws Error whatever assembly throws
AssembledSystem assembled_system(const CoupledProblem& coupled, const Progress& progress = {});

}  // namespace isopatch::iga
