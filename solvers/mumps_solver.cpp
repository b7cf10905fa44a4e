#include "solvers/mumps_solver.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "solvers/blas_threads.hpp"
#include "solvers/internal/petsc_objects.hpp"
#include "solvers/internal/petsc_session.hpp"
#include "solvers/pivot_check.hpp"
#include "solvers/refinement.hpp"
#include "solvers/stopwatch.hpp"

namespace isopatch::solvers {
namespace {

// Numbers of the MUMPS users' guide.
namespace icntl {
constexpr int root_parallelism = 13, extra_workspace = 14, null_pivots = 24;
}
namespace infog {
constexpr int status = 1, detail = 2, memory_megabytes = 19, factor_entries = 29, negative_pivots = 12,
              null_pivots = 28;
}
namespace status {
constexpr int integer_workspace = -8, workspace = -9, singular = -10, allocation = -13, out_of_core = -19;
}

class SymmetricFactorization {
 public:
  // `upper` must outlive the factorization.
  SymmetricFactorization(MPI_Comm communicator, CompressedRows<PetscInt>& upper)
      : communicator_(communicator), rows_(static_cast<PetscInt>(upper.row_start.size()) - 1) {
    petsc::check(MatCreateSeqSBAIJWithArrays(communicator, 1, rows_, rows_, upper.row_start.data(),
                                             upper.columns.data(), upper.values.data(), matrix_.receive()),
                 "take over the matrix");
    petsc::check(MatGetFactor(matrix_.get(), MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor_.receive()),
                 "prepare MUMPS");
    // A root node left to one process: ScaLAPACK would not count its negative pivots.
    set(icntl::root_parallelism, 1);
    set(icntl::extra_workspace, workspace_percent_);
    set(icntl::null_pivots, 1);
    constexpr int null_pivot_threshold = 3;
    petsc::check(MatMumpsSetCntl(factor_.get(), null_pivot_threshold, smallest_pivot_ratio(rows_)),
                 "set an option of MUMPS");
  }

  void analyze() {
    petsc::IndexSet natural;
    petsc::check(ISCreateStride(PETSC_COMM_SELF, rows_, 0, 1, natural.receive()), "number the rows");
    MatFactorInfo info;
    petsc::check(MatFactorInfoInitialize(&info), "prepare the analysis");
    petsc::check(MatCholeskyFactorSymbolic(factor_.get(), matrix_.get(), natural.get(), &info),
                 "run MUMPS' analysis");
    if (get(infog::status) < 0) fail("analysis");
  }

  // Enlarges MUMPS' workspace as long as pivoting needs more than was foreseen.
  void factorize() {
    constexpr int most_workspace_percent = 3200;
    const BlasThreads threads;
    MatFactorInfo info;
    petsc::check(MatFactorInfoInitialize(&info), "prepare the factorization");
    while (true) {
      petsc::check(MatCholeskyFactorNumeric(factor_.get(), matrix_.get(), &info), "run MUMPS' factorization");
      const int code = get(infog::status);
      if (code >= 0) return;
      const bool too_small = code == status::workspace || code == status::integer_workspace;
      if (!too_small || workspace_percent_ >= most_workspace_percent) fail("factorization");
      workspace_percent_ *= 2;
      set(icntl::extra_workspace, workspace_percent_);
    }
  }

  // Checks that the matrix has `negative` negative eigenvalues and no zero one.
  void check_inertia(int negative) const {
    const int zero = get(infog::null_pivots), found = get(infog::negative_pivots);
    if (zero > 0)
      throw Error(
          ErrorCode::singular_system,
          fmt::format("the matrix of {} rows is singular: {} of its pivots are zero to working precision; a "
                      "part can move as a rigid body, or constraints depend on each other",
                      rows_, zero));
    if (found != negative)
      throw Error(
          ErrorCode::singular_system,
          fmt::format("the matrix of {} rows has {} negative pivots instead of {}, one for each constraint: "
                      "the stiffness is not positive definite where the constraints hold",
                      rows_, found, negative));
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    const BlasThreads threads;
    Eigen::VectorXd x(b.size());
    const petsc::Vector right_side = petsc::view(communicator_, b, 1),
                        solution = petsc::view(communicator_, x, 1);
    petsc::check(MatSolve(factor_.get(), right_side.get(), solution.get()), "solve with MUMPS' factors");
    return x;
  }

  std::int64_t factor_entries() const {
    const std::int64_t entries = get(infog::factor_entries);  // negative: in millions
    return entries >= 0 ? entries : -1'000'000 * entries;
  }
  double flops() const {
    constexpr int during_factorization = 3;
    PetscReal value = 0;
    petsc::check(MatMumpsGetRinfog(factor_.get(), during_factorization, &value), "ask MUMPS for its work");
    return value;
  }
  std::int64_t peak_bytes() const { return std::int64_t{1'000'000} * get(infog::memory_megabytes); }

 private:
  void set(int option, int value) {
    petsc::check(MatMumpsSetIcntl(factor_.get(), option, value), "set an option of MUMPS");
  }
  int get(int number) const {
    PetscInt value = 0;
    petsc::check(MatMumpsGetInfog(factor_.get(), number, &value), "ask MUMPS for its state");
    return value;
  }

  [[noreturn]] void fail(std::string_view phase) const {
    const int code = get(infog::status), detail = get(infog::detail);
    if (code == status::singular)
      throw Error(ErrorCode::singular_system,
                  fmt::format("MUMPS found the matrix of {} rows singular", rows_));
    if (code == status::allocation || code == status::workspace || code == status::out_of_core) {
      // Negative: in millions of entries of 8 bytes.
      const double bytes = 8.0 * (detail < 0 ? -1e6 * detail : detail);
      throw Error(
          ErrorCode::out_of_memory,
          fmt::format("MUMPS ran out of memory in its {}: it asked for {:.0f} bytes more for a matrix of {} "
                      "rows; use elimination instead of multipliers, or a coarser space",
                      phase, bytes, rows_));
    }
    throw Error(ErrorCode::internal,
                fmt::format("MUMPS failed in its {} with INFOG(1) = {}, INFOG(2) = {}", phase, code, detail));
  }

  MPI_Comm communicator_;
  PetscInt rows_;
  int workspace_percent_ = 50;
  petsc::Matrix matrix_;
  petsc::Matrix factor_;
};

}  // namespace

LinearSolution solve_with_mumps(const LinearSystem& system, const SolverOptions& options,
                                const Progress& progress) {
  start_petsc();
  Stopwatch watch;
  SolveReport report;
  report.method = Method::mumps;
  progress("ordering", 0);
  const ScaledSystem scaled(system);
  CompressedRows<PetscInt> upper = upper_triangle<PetscInt>(scaled);
  SymmetricFactorization factorization(PETSC_COMM_WORLD, upper);
  factorization.analyze();
  report.analysis_seconds = watch.lap();
  progress("factorization", 0);
  factorization.factorize();
  factorization.check_inertia(static_cast<int>(system.constraints.rows()));
  report.factorization_seconds = watch.lap();
  progress("solution", 0);
  RefinedSolution refined = solve_and_refine(
      scaled, [&](const Eigen::VectorXd& b) { return factorization.solve(b); }, options.tolerance);
  report.solve_seconds = watch.lap();
  report.residual_history = std::move(refined.history);
  report.iterations = static_cast<int>(report.residual_history.size()) - 1;
  report.factor_nonzeros = factorization.factor_entries();
  report.factor_flops = factorization.flops();
  report.memory_bytes = factorization.peak_bytes() + upper.bytes();
  return {scaled.unknowns(refined.z), scaled.multipliers(refined.z), std::move(report)};
}

}  // namespace isopatch::solvers
