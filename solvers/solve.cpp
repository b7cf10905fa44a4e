#include "solvers/solve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <new>
#include <utility>

#include "geometry/base/error.hpp"
#include "solvers/cg_solver.hpp"
#include "solvers/cholmod_solver.hpp"
#include "solvers/mumps_solver.hpp"
#include "solvers/scaled_system.hpp"
#include "solvers/umfpack_solver.hpp"

namespace isopatch::solvers {
namespace {

[[noreturn]] void refuse(const std::string& message) {
  throw Error(ErrorCode::invalid_argument, message);
}

void check_sizes(const LinearSystem& system) {
  const SymmetricBlockMatrix& matrix = system.stiffness;
  const auto blocks = static_cast<std::size_t>(matrix.blocks());
  if (matrix.row_start.empty() || matrix.row_start.front() != 0 ||
      matrix.row_start.back() != matrix.blocks() || matrix.values.size() != block_entries * blocks)
    refuse(
        fmt::format("the block matrix is inconsistent: {} columns, {} values", blocks, matrix.values.size()));
  if (system.has_constraints() && system.constraints.cols() != matrix.rows())
    refuse(fmt::format("the constraints have {} columns, the matrix {} rows", system.constraints.cols(),
                       matrix.rows()));
}

void check_columns(const SymmetricBlockMatrix& matrix) {
  for (int row = 0; row < matrix.block_rows(); ++row) {
    const std::int64_t begin = matrix.row_start[row], end = matrix.row_start[row + 1];
    if (begin >= end || matrix.columns[begin] != row)
      refuse(fmt::format("block row {} does not start with its diagonal block", row));
    for (std::int64_t k = begin + 1; k < end; ++k)
      if (matrix.columns[k] <= matrix.columns[k - 1] || matrix.columns[k] >= matrix.block_rows())
        refuse(
            fmt::format("block row {}: column {} is out of order or out of range", row, matrix.columns[k]));
  }
}

void check_values(const LinearSystem& system) {
  const SymmetricBlockMatrix& matrix = system.stiffness;
  for (int row = 0; row < matrix.block_rows(); ++row)
    for (std::int64_t k = block_entries * matrix.row_start[row];
         k < block_entries * matrix.row_start[row + 1]; ++k)
      if (!std::isfinite(matrix.values[k]))
        refuse(fmt::format("the matrix is not a number or infinite in block row {}, block column {}", row,
                           matrix.columns[k / block_entries]));
  for (Eigen::Index i = 0; i < system.constraints.rows(); ++i)
    for (ConstraintMatrix::InnerIterator it(system.constraints, i); it; ++it)
      if (!std::isfinite(it.value()))
        refuse(fmt::format("the constraints are not a number or infinite in row {}, column {}", i, it.col()));
}

void check_load(const Eigen::VectorXd& load, const LinearSystem& system) {
  const SymmetricBlockMatrix& matrix = system.stiffness;
  const bool has_both = load.size() == matrix.rows() + system.constraints.rows();
  if (load.size() != matrix.rows() && !has_both)
    refuse(fmt::format("the load has {} entries, the matrix {} rows", load.size(), matrix.rows()));
  for (Eigen::Index i = 0; i < load.size(); ++i)
    if (!std::isfinite(load[i]))
      refuse(i < matrix.rows()
                 ? fmt::format("the load is not a number or infinite at block row {}, component {} of 3",
                               i / block_size, i % block_size)
                 : fmt::format("what constraint {} must be is not a number or infinite", i - matrix.rows()));
}

void check_method(const LinearSystem& system, const SolverOptions& options) {
  const Method method = options.method;
  if (method == Method::automatic)
    refuse(
        "method 'auto' is not for a matrix alone; name one: 'cholmod' without constraints, 'mumps' with "
        "them");
  if (method == Method::minres)
    refuse("method 'minres' needs a multigrid, which a matrix alone does not give");
  if (method == Method::cg && options.preconditioner == Preconditioner::multigrid)
    refuse("preconditioner 'multigrid' is not to be had from a matrix alone; use 'block_jacobi'");
  if (options.form == Operator::matrix_free)
    refuse("operator 'matrix_free' is for systems without a matrix; this one has one");
  if (system.has_constraints() && (method == Method::cholmod || method == Method::cg))
    refuse(
        fmt::format("method '{}' cannot treat the {} constraints; use 'mumps' or 'umfpack', or eliminate "
                    "the interfaces",
                    name(method), system.constraint_count()));
  if (system.rows.is_distributed() && method != Method::mumps)
    refuse(fmt::format(
        "method '{}' with a matrix works on one process, and there are {}; use 'mumps', or start one "
        "process with more threads",
        name(method), system.rows.processes().count()));
}

std::int64_t matrix_nonzeros(const LinearSystem& system) {
  return system.rows.processes().sum(system.stiffness.nonzeros() +
                                     std::int64_t{2} * system.constraints.nonZeros());
}

std::vector<LinearSolution> solve_with(Method method, const ScaledSystems& systems,
                                       const SolverOptions& options, const Progress& progress) {
  switch (method) {
    case Method::automatic:
      break;
    case Method::cholmod:
      return solve_with_cholmod(systems, options, progress);
    case Method::mumps:
      return solve_with_mumps(systems, options, progress);
    case Method::umfpack:
      return solve_with_umfpack(systems, options, progress);
    case Method::cg:
      return solve_with_cg(systems, options, progress);
    case Method::minres:
      break;
  }
  throw Error(ErrorCode::internal, "a method that needs more than a matrix came to a matrix");
}

// Insists on the residual. Iterations only update it, so it is computed afresh for them; factors have theirs
// from the solution itself, in extended precision.
LinearSolution verified(LinearSolution solution, const ScaledSystem& scaled, const SolverOptions& options) {
  const LinearSystem& system = scaled.system();
  SolveReport& report = solution.report;
  report.matrix_nonzeros = matrix_nonzeros(system);
  report.assembly_seconds = system.assembly_seconds;
  const Eigen::VectorXd z = scaled.join(solution.x, solution.multipliers);
  if (report.method == Method::cg) report.relative_residual = scaled.relative_residual(z);
  if (report.relative_residual <= options.tolerance) return solution;
  // Where the load is small beside the forces that cancel inside the body, no vector of doubles comes nearer.
  constexpr double worst_rounding_level = 1e-6;
  const double level = scaled.rounding_level(z);
  if (level <= worst_rounding_level && report.relative_residual <= level) {
    report.reason = fmt::format("the relative residual of {:.1e} is what double precision allows",
                                report.relative_residual);
    return solution;
  }
  const std::string_view advice =
      report.method == Method::cg ? "raise max_iterations, or use a direct method ('cholmod')"
                                  : "the matrix is badly conditioned; use an iterative method, or loosen the "
                                    "tolerance";
  throw Error(
      ErrorCode::not_converged,
      fmt::format(
          "method '{}' reached a relative residual of {:.3e} instead of {:.3e} after {} iterations; {}",
          name(report.method), report.relative_residual, options.tolerance, report.iterations, advice));
}

LinearSolution zero_solution(const LinearSystem& system, Method method) {
  LinearSolution solution;
  solution.x = Eigen::VectorXd::Zero(system.stiffness.rows());
  solution.multipliers = Eigen::VectorXd::Zero(system.constraints.rows());
  solution.report.method = method;
  solution.report.reason = "nothing to solve: the load is zero";
  solution.report.residual_history = {0};
  solution.report.matrix_nonzeros = matrix_nonzeros(system);
  solution.report.assembly_seconds = system.assembly_seconds;
  return solution;
}

}  // namespace

std::vector<LinearSolution> solve_each(const LinearSystem& system, const std::vector<Eigen::VectorXd>& loads,
                                       const SolverOptions& options, const Progress& progress) {
  validate(options);
  check_sizes(system);
  check_columns(system.stiffness);
  for (const Eigen::VectorXd& load : loads) check_load(load, system);
  check_values(system);
  check_method(system, options);
  std::vector<LinearSolution> result;
  ScaledSystems systems;
  std::vector<bool> is_zero;
  for (const Eigen::VectorXd& load : loads) {
    ScaledSystem scaled(system, load);
    is_zero.push_back(scaled.load_norm() == 0);
    if (!is_zero.back()) systems.push_back(std::move(scaled));
  }
  try {
    std::vector<LinearSolution> solved;
    if (!systems.empty()) solved = solve_with(options.method, systems, options, progress);
    std::size_t next = 0;
    for (const bool is_nothing : is_zero) {
      if (is_nothing) {
        result.push_back(zero_solution(system, options.method));
      } else {
        result.push_back(verified(std::move(solved[next]), systems[next], options));
        ++next;
      }
    }
    return result;
  } catch (const std::bad_alloc&) {
    throw Error(
        ErrorCode::out_of_memory,
        fmt::format(
            "no memory left for a copy of the matrix, whose {} blocks take {} bytes; use method 'cg', "
            "a coarser space, or a machine with more memory",
            system.stiffness.blocks(), system.stiffness.bytes()));
  }
}

LinearSolution solve(const LinearSystem& system, const SolverOptions& options, const Progress& progress) {
  return std::move(solve_each(system, {system.load}, options, progress).front());
}

}  // namespace isopatch::solvers
