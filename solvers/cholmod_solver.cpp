#include "solvers/cholmod_solver.hpp"

#include <fmt/format.h>

#include <memory>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "solvers/blas_threads.hpp"
#include "solvers/block_ordering.hpp"
#include "solvers/internal/cholmod_api.hpp"
#include "solvers/pivot_check.hpp"
#include "solvers/refinement.hpp"

namespace isopatch::solvers {
namespace {

// The permuted matrix as its lower triangle by columns; the k-th block row of the order makes columns 3k to
// 3k + 2.
template <class Index>
CompressedRows<Index> permuted_lower_triangle(const SymmetricBlockMatrix& matrix,
                                              const BlockOrdering& ordering) {
  const int n = matrix.block_rows();
  CompressedRows<Index> lower;
  std::vector<Index> blocks(n, 0);
  for (int row = 0; row < n; ++row)
    for (std::int64_t k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k)
      ++blocks[std::min(ordering.position[row], ordering.position[matrix.columns[k]])];
  lower.row_start.resize(block_size * static_cast<std::size_t>(n) + 1, 0);
  for (int i = 0; i < block_size * n; ++i)
    lower.row_start[i + 1] = lower.row_start[i] + block_size * blocks[i / block_size] - i % block_size;
  lower.columns.resize(lower.row_start.back());
  lower.values.resize(lower.row_start.back());
  std::vector<Index> filled(n, block_size);  // rows of the diagonal block come first
  for (int row = 0; row < n; ++row) {
    for (std::int64_t k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k) {
      const int a = ordering.position[row], b = ordering.position[matrix.columns[k]];
      const int first = std::min(a, b), second = std::max(a, b);
      const double* const block = matrix.values.data() + block_entries * k;
      for (int i = 0; i < block_size; ++i) {
        const Index start = lower.row_start[block_size * first + i] + (a == b ? -i : filled[first] - i);
        for (int j = a == b ? i : 0; j < block_size; ++j) {
          lower.columns[start + j] = static_cast<Index>(block_size * second + j);
          lower.values[start + j] = a <= b ? block[block_size * i + j] : block[block_size * j + i];
        }
      }
      if (a != b) filled[first] += block_size;
    }
  }
  return lower;
}

// One factorization with indices of one width.
template <class Index>
class Cholesky {
 public:
  Cholesky(const SymmetricBlockMatrix& matrix, const BlockOrdering& ordering)
      : matrix_(matrix),
        ordering_(ordering),
        lower_(permuted_lower_triangle<Index>(matrix, ordering)),
        view_(lower_triangle_view<Index>(lower_.row_start.size() - 1, lower_.row_start.data(),
                                         lower_.columns.data(), lower_.values.data(), false)),
        factor_(analyze(), workspace_) {}

  // False if the factor has too many entries for this width of index.
  bool fits() const { return factor_.get() != nullptr; }

  void factorize() {
    const BlasThreads threads;
    Api::factorize(&view_, factor_.get(), workspace_.get());
    check_status();
    matrix_bytes_ = lower_.bytes();
    diagonal_.resize(matrix_.rows());
    for (int column = 0; column < matrix_.rows(); ++column)
      diagonal_[column] = lower_.values[lower_.row_start[column]];
    lower_ = {};
  }

  // A singular matrix usually passes CHOLMOD's own test, which asks for positive pivots and no more.
  void check_pivots() {
    const auto* const first_column = static_cast<const Index*>(factor_->super);
    const auto* const row_start = static_cast<const Index*>(factor_->pi);
    const auto* const value_start = static_cast<const Index*>(factor_->px);
    const auto* const values = static_cast<const double*>(factor_->x);
    const double smallest = smallest_pivot_ratio(matrix_.rows());
    for (std::size_t s = 0; s < factor_->nsuper; ++s) {
      const std::int64_t height = row_start[s + 1] - row_start[s];
      for (std::int64_t k = 0; k < first_column[s + 1] - first_column[s]; ++k) {
        const std::int64_t column = first_column[s] + k;
        const double root = values[value_start[s] + k * (height + 1)];
        const double ratio = root * root / diagonal_[column];
        if (!(ratio > smallest))
          fail_at(
              static_cast<std::size_t>(column),
              fmt::format("a pivot of {:.1e} times its diagonal entry, so zero but for round-off,", ratio));
      }
    }
  }

  // Column by column.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) {
    Eigen::MatrixXd permuted(b.rows(), b.cols());
    for (Eigen::Index j = 0; j < b.cols(); ++j)
      for (std::size_t k = 0; k < ordering_.order.size(); ++k)
        permuted.col(j).segment<block_size>(block_size * k) =
            b.col(j).segment<block_size>(block_size * static_cast<Eigen::Index>(ordering_.order[k]));
    cholmod_dense view = {};
    view.nrow = view.d = static_cast<std::size_t>(b.rows());
    view.ncol = static_cast<std::size_t>(b.cols());
    view.nzmax = view.nrow * view.ncol;
    view.x = permuted.data();
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    const BlasThreads threads;
    cholmod_dense* solution = Api::solve(CHOLMOD_A, factor_.get(), &view, workspace_.get());
    if (!solution) fail_out_of_memory(8.0 * b.size());
    const Eigen::Map<const Eigen::MatrixXd> values(static_cast<const double*>(solution->x), b.rows(),
                                                   b.cols());
    Eigen::MatrixXd x(b.rows(), b.cols());
    for (Eigen::Index j = 0; j < b.cols(); ++j)
      for (std::size_t k = 0; k < ordering_.order.size(); ++k)
        x.col(j).segment<block_size>(block_size * static_cast<Eigen::Index>(ordering_.order[k])) =
            values.col(j).segment<block_size>(block_size * k);
    Api::free_dense(&solution, workspace_.get());
    return x;
  }

  double entries() { return workspace_->lnz; }
  double flops() { return workspace_->fl; }
  std::int64_t peak_bytes() { return static_cast<std::int64_t>(workspace_->memory_usage) + matrix_bytes_; }

 private:
  using Api = CholmodApi<Index>;

  cholmod_factor* analyze() {
    workspace_->nmethods = 1;
    workspace_->method[0].ordering = CHOLMOD_NATURAL;
    workspace_->postorder = false;
    workspace_->supernodal = CHOLMOD_SUPERNODAL;
    cholmod_factor* const factor = Api::analyze(&view_, workspace_.get());
    if (!factor && workspace_->status == CHOLMOD_OUT_OF_MEMORY) fail_out_of_memory(lower_.bytes());
    if (!factor && (workspace_->status != CHOLMOD_TOO_LARGE || sizeof(Index) == 8))
      throw Error(ErrorCode::internal,
                  fmt::format("CHOLMOD's analysis failed with status {}", workspace_->status));
    return factor;
  }

  [[noreturn]] void fail_out_of_memory(double bytes) {
    throw Error(
        ErrorCode::out_of_memory,
        fmt::format("the Cholesky factor of {} unknowns needs {:.0f} bytes more than the {} bytes held; use "
                    "method 'cg', a coarser space, or a machine with more memory",
                    matrix_.rows(), bytes, workspace_->memory_inuse));
  }

  [[noreturn]] void fail_at(std::size_t column, std::string_view finding) {
    throw Error(
        ErrorCode::singular_system,
        fmt::format(
            "the matrix is not positive definite to working precision: {} at block row {}, component {} of 3",
            finding, ordering_.order[column / block_size], column % block_size));
  }

  void check_status() {
    if (workspace_->status == CHOLMOD_OUT_OF_MEMORY)
      fail_out_of_memory(8.0 * static_cast<double>(factor_->xsize));
    if (workspace_->status == CHOLMOD_NOT_POSDEF) fail_at(factor_->minor, "a zero or negative pivot");
    if (workspace_->status < CHOLMOD_OK)
      throw Error(ErrorCode::internal,
                  fmt::format("CHOLMOD's factorization failed with status {}", workspace_->status));
  }

  const SymmetricBlockMatrix& matrix_;
  const BlockOrdering& ordering_;
  CompressedRows<Index> lower_;
  std::int64_t matrix_bytes_ = 0;
  Eigen::VectorXd diagonal_;
  CholmodWorkspace<Index> workspace_;
  cholmod_sparse view_;
  CholmodFactor<Index> factor_;
};

template <class Index>
std::vector<LinearSolution> factorize_and_solve(Cholesky<Index>& cholesky, const ScaledSystems& systems,
                                                const SolverOptions& options, const Progress& progress,
                                                Stopwatch& watch, SolveReport report) {
  report.analysis_seconds = watch.lap();
  progress("factorization", 0);
  cholesky.factorize();
  cholesky.check_pivots();
  report.factorization_seconds = watch.lap();
  progress("solution", 0);
  std::vector<RefinedSolution> refined = solve_and_refine(
      systems, [&](const Eigen::MatrixXd& b) { return cholesky.solve(b); }, options.tolerance);
  report.factor_nonzeros = static_cast<std::int64_t>(cholesky.entries());
  report.factor_flops = cholesky.flops();
  report.memory_bytes = cholesky.peak_bytes();
  return with_reports(systems, std::move(refined), report, watch.lap());
}

}  // namespace

std::vector<LinearSolution> solve_with_cholmod(const ScaledSystems& systems, const SolverOptions& options,
                                               const Progress& progress) {
  const LinearSystem& system = systems.front().system();
  Stopwatch watch;
  SolveReport report;
  report.method = Method::cholmod;
  progress("ordering", 0);
  const BlockOrdering ordering = fill_reducing_ordering(system.stiffness);
  if (block_entries * system.stiffness.blocks() <= std::numeric_limits<std::int32_t>::max()) {
    Cholesky<std::int32_t> cholesky(system.stiffness, ordering);
    if (cholesky.fits())
      return factorize_and_solve(cholesky, systems, options, progress, watch, std::move(report));
  }
  Cholesky<std::int64_t> cholesky(system.stiffness, ordering);
  return factorize_and_solve(cholesky, systems, options, progress, watch, std::move(report));
}

namespace {

struct Inverse {
  explicit Inverse(SymmetricBlockMatrix m)
      : matrix(std::move(m)), ordering(fill_reducing_ordering(matrix)), cholesky(matrix, ordering) {
    cholesky.factorize();
  }
  SymmetricBlockMatrix matrix;
  BlockOrdering ordering;
  Cholesky<std::int64_t> cholesky;
};

}  // namespace

BlockOperator cholmod_block_inverse(SymmetricBlockMatrix matrix) {
  const auto inverse = std::make_shared<Inverse>(std::move(matrix));
  inverse->cholesky.check_pivots();
  return [inverse](const Eigen::MatrixXd& b) { return inverse->cholesky.solve(b); };
}

VectorsOperator cholmod_inverse(SymmetricBlockMatrix matrix) {
  const auto inverse = std::make_shared<Inverse>(std::move(matrix));
  return {[inverse](const Eigen::VectorXd& b) -> Eigen::VectorXd { return inverse->cholesky.solve(b); },
          [inverse](const Eigen::MatrixXd& b) { return inverse->cholesky.solve(b); }};
}

}  // namespace isopatch::solvers
