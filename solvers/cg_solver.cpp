#include "solvers/cg_solver.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>

#include "geometry/base/error.hpp"
#include "solvers/conjugate_gradients.hpp"
#include "solvers/petsc_session.hpp"
#include "solvers/scaled_system.hpp"
#include "solvers/stopwatch.hpp"

namespace isopatch::solvers {
namespace {

using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

void check_diagonal_blocks(const SymmetricBlockMatrix& matrix) {
  for (int row = 0; row < matrix.block_rows(); ++row) {
    const Eigen::Map<const Block> block(matrix.values.data() + 9 * matrix.row_start[row]);
    if (Eigen::LLT<Block>(block).info() != Eigen::Success)
      throw Error(
          ErrorCode::singular_system,
          fmt::format("the matrix is not positive definite: its diagonal block {} has no Cholesky factor",
                      row));
  }
}

petsc::Matrix petsc_matrix(MPI_Comm communicator, const SymmetricBlockMatrix& matrix) {
  using petsc::check;
  if (matrix.blocks() > PETSC_MAX_INT)
    throw Error(
        ErrorCode::unsupported,
        fmt::format("the matrix has {} blocks, more than PETSc's indices can count", matrix.blocks()));
  const int n = matrix.block_rows();
  std::vector<PetscInt> row_blocks(n);
  for (int row = 0; row < n; ++row)
    row_blocks[row] = static_cast<PetscInt>(matrix.row_start[row + 1] - matrix.row_start[row]);
  petsc::Matrix copy;
  check(MatCreateSBAIJ(communicator, SymmetricBlockMatrix::block_size, 3 * n, 3 * n, PETSC_DETERMINE,
                       PETSC_DETERMINE, 0, row_blocks.data(), 0, nullptr, copy.receive()),
        "make the matrix");
  for (PetscInt row = 0; row < n; ++row)
    check(MatSetValuesBlocked(copy.get(), 1, &row, row_blocks[row],
                              matrix.columns.data() + matrix.row_start[row],
                              matrix.values.data() + 9 * matrix.row_start[row], INSERT_VALUES),
          "fill the matrix");
  check(MatAssemblyBegin(copy.get(), MAT_FINAL_ASSEMBLY), "assemble the matrix");
  check(MatAssemblyEnd(copy.get(), MAT_FINAL_ASSEMBLY), "assemble the matrix");
  return copy;
}

void block_jacobi(PC preconditioner) {
  petsc::check(PCSetType(preconditioner, PCPBJACOBI), "choose the preconditioner");
}

std::int64_t bytes_of(const petsc::Matrix& matrix) {
  MatInfo info;
  petsc::check(MatGetInfo(matrix.get(), MAT_LOCAL, &info), "ask for the matrix's memory");
  return static_cast<std::int64_t>(info.memory);
}

void check_reason(KSPConvergedReason reason, int iterations) {
  if (reason == KSP_DIVERGED_INDEFINITE_MAT || reason == KSP_DIVERGED_INDEFINITE_PC)
    throw Error(
        ErrorCode::singular_system,
        fmt::format(
            "conjugate gradients met a direction without positive energy in iteration {}: the matrix is "
            "singular or indefinite; look for a part that can move freely",
            iterations));
}

}  // namespace

LinearSolution solve_with_cg(const LinearSystem& system, const SolverOptions& options,
                             const Progress& progress) {
  start_petsc();
  Stopwatch watch;
  SolveReport report;
  report.method = Method::cg;
  progress("preconditioner", 0);
  check_diagonal_blocks(system.stiffness);
  const petsc::Matrix matrix = petsc_matrix(PETSC_COMM_WORLD, system.stiffness);
  constexpr int work_vectors = 5;
  report.memory_bytes = bytes_of(matrix) + 8 * std::int64_t{work_vectors + 3} * system.stiffness.rows();
  report.analysis_seconds = watch.lap();

  const ScaledSystem scaled(system);
  const double load_norm = system.load.stableNorm();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.load.size());
  Eigen::VectorXd residual = system.load;
  double relative = 1;
  report.residual_history.push_back(relative);
  constexpr int most_restarts = 5;
  for (int restart = 0; restart <= most_restarts && relative > options.tolerance; ++restart) {
    // A little below the tolerance, for the residual of the sum is not the updated residual.
    const KrylovOptions krylov{0.5 * options.tolerance * load_norm,
                               options.max_iterations - report.iterations};
    if (krylov.max_iterations <= 0) break;
    const KrylovSolution step = conjugate_gradients(matrix, block_jacobi, residual, krylov, progress);
    const int iterations = static_cast<int>(step.residual_norms.size()) - 1;
    for (int i = 1; i <= iterations; ++i)
      report.residual_history.push_back(step.residual_norms[i] / load_norm);
    report.iterations += iterations;
    check_reason(step.reason, report.iterations);
    x += step.x;
    residual = scaled.residual(x);
    const double before = std::exchange(relative, residual.stableNorm() / load_norm);
    report.residual_history.back() = relative;
    if (!(relative < 0.9 * before)) break;
  }
  report.solve_seconds = watch.lap();
  return {std::move(x), {}, std::move(report)};
}

}  // namespace isopatch::solvers
