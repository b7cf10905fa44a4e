#pragma once

#include <vector>

#include "iga/assembly/assembly.hpp"
#include "iga/solution/nodal_solution.hpp"

namespace isopatch::iga {

/// The equations of a task as `solvers::solve` takes them: of block row r the displacement is
/// prescribed + axes * x in the frame `frame_of_row[r]`.
struct AssembledSystem {
  solvers::LinearSystem system;                   ///< of this process
  RowNumbering numbering;                         ///< of the whole system
  std::vector<const SupportFrame*> frame_of_row;  ///< of the whole system; the task's
};

/// @throws Error whatever assembly throws
AssembledSystem assembled_system(const SolutionTask& task, const Progress& progress = {});

}  // namespace isopatch::iga
