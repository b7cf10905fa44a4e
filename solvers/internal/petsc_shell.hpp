#pragma once

#include <functional>

#include "solvers/internal/petsc_objects.hpp"

namespace isopatch::solvers {

/// A linear map of vectors, for example the product with a matrix that is never assembled.
using LinearOperator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

}  // namespace isopatch::solvers

namespace isopatch::solvers::petsc {

/// A PETSc matrix that applies `apply`, which must outlive it. Block size 3. (rows x rows)
Matrix shell_matrix(MPI_Comm communicator, int rows, const LinearOperator& apply);

/// Makes a preconditioner apply `apply`, which must outlive it.
void use_shell(PC preconditioner, const LinearOperator& apply);

}  // namespace isopatch::solvers::petsc
