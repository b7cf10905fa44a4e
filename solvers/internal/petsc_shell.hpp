#pragma once

#include "solvers/internal/petsc_objects.hpp"
#include "solvers/linear_operator.hpp"

namespace isopatch::solvers::petsc {

/// A PETSc matrix that applies `apply`, which must outlive it. Block size 3. (rows x rows)
Matrix shell_matrix(MPI_Comm communicator, int rows, const LinearOperator& apply);

/// Makes a preconditioner apply `apply`, which must outlive it.
void use_shell(PC preconditioner, const LinearOperator& apply);

}  // namespace isopatch::solvers::petsc
