#include "solvers/umfpack_solver.hpp"

#include <fmt/format.h>
#include <umfpack.h>

#include <array>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "solvers/blas_threads.hpp"
#include "solvers/pivot_check.hpp"
#include "solvers/refinement.hpp"

namespace isopatch::solvers {
namespace {

class UnsymmetricFactorization {
 public:
  explicit UnsymmetricFactorization(const ScaledSystem& system) : matrix_(full_matrix(system)) {
    umfpack_dl_defaults(control_.data());
    control_[UMFPACK_PRL] = 0;
    control_[UMFPACK_IRSTEP] = 0;  // refinement is our own, in extended precision
    control_[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;
  }
  ~UnsymmetricFactorization() {
    umfpack_dl_free_symbolic(&symbolic_);
    umfpack_dl_free_numeric(&numeric_);
  }
  UnsymmetricFactorization(const UnsymmetricFactorization&) = delete;
  UnsymmetricFactorization& operator=(const UnsymmetricFactorization&) = delete;

  void analyze() {
    check(umfpack_dl_symbolic(rows(), rows(), row_start(), columns(), values(), &symbolic_, control_.data(),
                              info_.data()));
  }

  void factorize() {
    const BlasThreads threads;
    check(umfpack_dl_numeric(row_start(), columns(), values(), symbolic_, &numeric_, control_.data(),
                             info_.data()));
    if (!(info_[UMFPACK_RCOND] > smallest_pivot_ratio(rows()))) fail_singular();
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) {
    Eigen::MatrixXd x(b.rows(), b.cols());
    for (Eigen::Index j = 0; j < b.cols(); ++j)
      check(umfpack_dl_solve(UMFPACK_A, row_start(), columns(), values(), x.col(j).data(), b.col(j).data(),
                             numeric_, control_.data(), info_.data()));
    return x;
  }

  double factor_entries() const { return info_[UMFPACK_LNZ] + info_[UMFPACK_UNZ]; }
  double flops() const { return info_[UMFPACK_FLOPS]; }
  double peak_bytes() const {
    return info_[UMFPACK_PEAK_MEMORY] * info_[UMFPACK_SIZE_OF_UNIT] + static_cast<double>(matrix_.bytes());
  }

 private:
  // UMFPACK's long is a type of its own. The matrix is symmetric: its rows serve as columns.
  using Long = SuiteSparse_long;
  static_assert(sizeof(Long) == sizeof(std::int64_t));
  Long rows() const { return static_cast<Long>(matrix_.row_start.size()) - 1; }
  const Long* row_start() const { return reinterpret_cast<const Long*>(matrix_.row_start.data()); }
  const Long* columns() const { return reinterpret_cast<const Long*>(matrix_.columns.data()); }
  const double* values() const { return matrix_.values.data(); }

  [[noreturn]] void fail_singular() const {
    throw Error(
        ErrorCode::singular_system,
        fmt::format(
            "the matrix of {} rows is singular to working precision: its smallest pivot is {:.1e} times "
            "its largest",
            rows(), info_[UMFPACK_RCOND]));
  }

  void check(Long status) const {
    if (status == UMFPACK_OK) return;
    if (status == UMFPACK_WARNING_singular_matrix) fail_singular();
    if (status == UMFPACK_ERROR_out_of_memory) {
      const double units = std::max(info_[UMFPACK_PEAK_MEMORY], info_[UMFPACK_PEAK_MEMORY_ESTIMATE]);
      throw Error(
          ErrorCode::out_of_memory,
          fmt::format("UMFPACK ran out of memory: it foresaw {:.0f} bytes for a matrix of {} rows; use "
                      "elimination instead of multipliers, or a coarser space",
                      std::max(0.0, units) * info_[UMFPACK_SIZE_OF_UNIT], rows()));
    }
    throw Error(ErrorCode::internal, fmt::format("UMFPACK failed with status {}", status));
  }

  CompressedRows<std::int64_t> matrix_;
  std::array<double, UMFPACK_CONTROL> control_ = {};
  std::array<double, UMFPACK_INFO> info_ = {};
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
};

}  // namespace

std::vector<LinearSolution> solve_with_umfpack(const ScaledSystems& systems, const SolverOptions& options,
                                               const Progress& progress) {
  Stopwatch watch;
  SolveReport report;
  report.method = Method::umfpack;
  progress("ordering", 0);
  UnsymmetricFactorization factorization(systems.front());
  factorization.analyze();
  report.analysis_seconds = watch.lap();
  progress("factorization", 0);
  factorization.factorize();
  report.factorization_seconds = watch.lap();
  report.factor_nonzeros = static_cast<std::int64_t>(factorization.factor_entries());
  report.factor_flops = factorization.flops();
  report.memory_bytes = static_cast<std::int64_t>(factorization.peak_bytes());
  progress("solution", 0);
  std::vector<RefinedSolution> refined = solve_and_refine(
      systems, [&](const Eigen::MatrixXd& b) { return factorization.solve(b); }, options.tolerance);
  return with_reports(systems, std::move(refined), report, watch.lap());
}

}  // namespace isopatch::solvers
