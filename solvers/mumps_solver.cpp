#include "solvers/mumps_solver.hpp"

#include <dmumps_c.h>
#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "solvers/blas_threads.hpp"
#include "solvers/internal/mpi_session.hpp"
#include "solvers/pivot_check.hpp"
#include "solvers/refinement.hpp"

namespace isopatch::solvers {
namespace {

// Numbers of the MUMPS users' guide.
namespace job {
constexpr int start = -1, end = -2, analysis = 1, factorization = 2, solution = 3;
}
namespace icntl {
constexpr int error_stream = 1, warning_stream = 2, information_stream = 3, printing = 4,
              root_parallelism = 13, extra_workspace = 14, distribution = 18, null_pivots = 24,
              analysis_parallelism = 28;
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
  // `entries` counted from 1; must outlive the factorization. The same on all processes: `rows`, which is
  // that of the whole system.
  SymmetricFactorization(const Processes& processes, std::int64_t rows, MatrixEntries& entries)
      : processes_(processes), rows_(rows) {
    mumps_.comm_fortran = processes.fortran_communicator();
    constexpr int general_symmetric = 2;
    mumps_.sym = general_symmetric;
    mumps_.par = 1;  // the first process works, too
    run(job::start);
    mumps_.n = static_cast<MUMPS_INT>(rows);
    mumps_.nnz_loc = static_cast<MUMPS_INT8>(entries.values.size());
    mumps_.irn_loc = entries.rows.data();
    mumps_.jcn_loc = entries.columns.data();
    mumps_.a_loc = entries.values.data();
    for (const int stream : {icntl::error_stream, icntl::warning_stream, icntl::information_stream})
      set(stream, -1);
    set(icntl::printing, 0);
    constexpr int by_processes = 3, sequential = 1;
    set(icntl::distribution, by_processes);
    set(icntl::analysis_parallelism, sequential);
    // A root node left to one process: ScaLAPACK would not count its negative pivots.
    set(icntl::root_parallelism, 1);
    set(icntl::extra_workspace, workspace_percent_);
    set(icntl::null_pivots, 1);
    constexpr int null_pivot_threshold = 3;
    mumps_.cntl[null_pivot_threshold - 1] = smallest_pivot_ratio(rows_);
  }

  // For constraints on several processes, which see a part of a column each when they choose a pivot: with
  // MUMPS' 0.01 three of four runs of a mortar model as 4 processes had residuals of 0.01 to 60, or a wrong
  // count of negative pivots (MUMPS 5.5.1); with 0.1 one needed six refinements, 0.5 keeps them at 1e-14.
  void choose_pivots_carefully() {
    constexpr int pivot_threshold = 1;
    mumps_.cntl[pivot_threshold - 1] = 0.5;
  }

  ~SymmetricFactorization() { run(job::end); }
  SymmetricFactorization(const SymmetricFactorization&) = delete;
  SymmetricFactorization& operator=(const SymmetricFactorization&) = delete;

  void analyze() {
    run(job::analysis);
    if (get(infog::status) < 0) fail("analysis");
  }

  // Enlarges MUMPS' workspace as long as pivoting needs more than was foreseen.
  void factorize() {
    constexpr int most_workspace_percent = 3200;
    const BlasThreads threads;
    while (true) {
      run(job::factorization);
      const int code = get(infog::status);
      if (code >= 0) return;
      const bool too_small = code == status::workspace || code == status::integer_workspace;
      if (!too_small || workspace_percent_ >= most_workspace_percent) fail("factorization");
      workspace_percent_ *= 2;
      set(icntl::extra_workspace, workspace_percent_);
    }
  }

  // Checks that the matrix has `negative` negative eigenvalues and no zero one.
  void check_inertia(std::int64_t negative) const {
    check_zero_pivots();
    const int found = get(infog::negative_pivots);
    if (found != negative)
      throw Error(
          ErrorCode::singular_system,
          fmt::format("the matrix of {} rows has {} negative pivots instead of {}, one for each constraint: "
                      "the stiffness is not positive definite where the constraints hold",
                      rows_, found, negative));
  }

  std::int64_t negative_pivots() const {
    check_zero_pivots();
    return get(infog::negative_pivots);
  }

  // Right sides and solutions of the whole system, on all processes. MUMPS wants the ones and gives the
  // others on the first.
  Eigen::MatrixXd solve(Eigen::MatrixXd b) {
    const BlasThreads threads;
    mumps_.rhs = b.data();
    mumps_.nrhs = static_cast<MUMPS_INT>(b.cols());
    mumps_.lrhs = mumps_.n;
    run(job::solution);
    if (get(infog::status) < 0) fail("solution");
    broadcast(b);
    return b;
  }

  std::int64_t factor_entries() const {
    const std::int64_t entries = get(infog::factor_entries);  // negative: in millions
    return entries >= 0 ? entries : -1'000'000 * entries;
  }
  double flops() const {
    constexpr int during_factorization = 3;
    return mumps_.rinfog[during_factorization - 1];
  }
  std::int64_t peak_bytes() const { return std::int64_t{1'000'000} * get(infog::memory_megabytes); }

 private:
  void check_zero_pivots() const {
    const int zero = get(infog::null_pivots);
    if (zero > 0)
      throw Error(ErrorCode::singular_system,
                  fmt::format("the matrix of {} rows is singular: {} of its pivots are zero to working "
                              "precision",
                              rows_, zero));
  }
  void broadcast(Eigen::MatrixXd& b) const {
    if (processes_.count() == 1) return;
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
      Eigen::VectorXd column = b.col(j);
      processes_.broadcast(column, 0);
      b.col(j) = column;
    }
  }
  void run(int what) {
    mumps_.job = what;
    dmumps_c(&mumps_);
  }
  void set(int option, int value) { mumps_.icntl[option - 1] = value; }
  int get(int number) const { return mumps_.infog[number - 1]; }

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

  Processes processes_;
  std::int64_t rows_;
  int workspace_percent_ = 50;
  DMUMPS_STRUC_C mumps_ = {};
};

// The inverse for local vectors, column by column.
Eigen::MatrixXd solve_local(SymmetricFactorization& factorization, const ScaledSystem& scaled,
                            const Eigen::MatrixXd& b) {
  const LinearSystem& system = scaled.system();
  if (!system.rows.is_distributed()) return factorization.solve(b);
  Eigen::MatrixXd whole(global_rows(scaled), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    whole.col(j) << system.rows.whole(scaled.unknowns(b.col(j))),
        system.multiplier_rows.whole(b.col(j).tail(system.constraints.rows()));
  const Eigen::MatrixXd z = factorization.solve(std::move(whole));
  const Eigen::Index unknowns = block_size * Eigen::Index{system.rows.global_rows()};
  Eigen::MatrixXd result(scaled.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    result.col(j) << system.rows.part(z.col(j).head(unknowns)),
        system.multiplier_rows.part(z.col(j).tail(z.rows() - unknowns));
  return result;
}

}  // namespace

std::vector<LinearSolution> solve_with_mumps(const ScaledSystems& systems, const SolverOptions& options,
                                             const Progress& progress) {
  const ScaledSystem& scaled = systems.front();
  const LinearSystem& system = scaled.system();
  start_mpi();
  Stopwatch watch;
  SolveReport report;
  report.method = Method::mumps;
  progress("ordering", 0);
  MatrixEntries entries = upper_entries(scaled, 1);
  SymmetricFactorization factorization(system.rows.processes(), global_rows(scaled), entries);
  if (system.has_constraints() && system.rows.is_distributed()) factorization.choose_pivots_carefully();
  factorization.analyze();
  report.analysis_seconds = watch.lap();
  progress("factorization", 0);
  factorization.factorize();
  factorization.check_inertia(system.constraint_count());
  report.factorization_seconds = watch.lap();
  progress("solution", 0);
  std::vector<RefinedSolution> refined = solve_and_refine(
      systems, [&](const Eigen::MatrixXd& b) { return solve_local(factorization, scaled, b); },
      options.tolerance);
  report.factor_nonzeros = factorization.factor_entries();
  report.factor_flops = factorization.flops();
  report.memory_bytes = factorization.peak_bytes() + system.rows.processes().sum(entries.bytes());
  return with_reports(systems, std::move(refined), report, watch.lap());
}

std::int64_t negative_eigenvalues(const SymmetricBlockMatrix& matrix) {
  start_mpi();
  LinearSystem system;
  system.stiffness = matrix;
  system.load = Eigen::VectorXd::Zero(matrix.rows());
  const ScaledSystem scaled(system);
  MatrixEntries entries = upper_entries(scaled, 1);
  SymmetricFactorization factorization(Processes(), global_rows(scaled), entries);
  factorization.analyze();
  factorization.factorize();
  return factorization.negative_pivots();
}

}  // namespace isopatch::solvers
