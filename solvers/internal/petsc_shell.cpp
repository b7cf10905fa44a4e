#include "solvers/internal/petsc_shell.hpp"

#include <exception>

#include "solvers/block_size.hpp"

namespace isopatch::solvers::petsc {
namespace {

// Applies an operator between PETSc vectors. Exceptions must not fly through PETSc's C code.
PetscErrorCode apply_operator(const LinearOperator& apply, Vec in, Vec out) {
  PetscInt size = 0;
  PetscCall(VecGetLocalSize(in, &size));
  const PetscScalar* values = nullptr;
  PetscCall(VecGetArrayRead(in, &values));
  PetscScalar* results = nullptr;
  PetscCall(VecGetArrayWrite(out, &results));
  PetscErrorCode code = 0;
  try {
    Eigen::Map<Eigen::VectorXd>(results, size) = apply(Eigen::Map<const Eigen::VectorXd>(values, size));
  } catch (const std::bad_alloc&) {
    code = PETSC_ERR_MEM;
  } catch (const std::exception&) {
    code = PETSC_ERR_USER;
  }
  PetscCall(VecRestoreArrayWrite(out, &results));
  PetscCall(VecRestoreArrayRead(in, &values));
  return code;
}

PetscErrorCode multiply_shell(Mat matrix, Vec in, Vec out) {
  void* context = nullptr;
  PetscCall(MatShellGetContext(matrix, &context));
  return apply_operator(*static_cast<const LinearOperator*>(context), in, out);
}

PetscErrorCode apply_shell(PC preconditioner, Vec in, Vec out) {
  void* context = nullptr;
  PetscCall(PCShellGetContext(preconditioner, &context));
  return apply_operator(*static_cast<const LinearOperator*>(context), in, out);
}

}  // namespace

Matrix shell_matrix(MPI_Comm communicator, int rows, const LinearOperator& apply) {
  Matrix matrix;
  check(MatCreateShell(communicator, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE,
                       const_cast<LinearOperator*>(&apply), matrix.receive()),
        "make a matrix shell");
  check(MatSetBlockSize(matrix.get(), 3), "set the block size");
  check(MatShellSetOperation(matrix.get(), MATOP_MULT, reinterpret_cast<void (*)()>(multiply_shell)),
        "set the product of a matrix shell");
  return matrix;
}

void use_shell(PC preconditioner, const LinearOperator& apply) {
  check(PCSetType(preconditioner, PCSHELL), "choose a preconditioner shell");
  check(PCShellSetContext(preconditioner, const_cast<LinearOperator*>(&apply)),
        "set up a preconditioner shell");
  check(PCShellSetApply(preconditioner, apply_shell), "set up a preconditioner shell");
}

}  // namespace isopatch::solvers::petsc
