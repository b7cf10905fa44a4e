#include "solvers/scaled_system.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/base/error.hpp"
#include "solvers/block_product.hpp"

namespace isopatch::solvers {
namespace {

using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

// The constraints' share s B^T y and s B x of the matrix times z, added to `sum`.
template <class Entry>
Extended with_constraints(Extended sum, const ConstraintMatrix& constraints, double scale,
                          const Eigen::VectorXd& z, const Entry& entry) {
  const Eigen::Index n = sum.size();
  sum.conservativeResize(n + constraints.rows());
  sum.tail(constraints.rows()).setZero();
  for (Eigen::Index i = 0; i < constraints.rows(); ++i) {
    for (ConstraintMatrix::InnerIterator it(constraints, i); it; ++it) {
      const long double value = static_cast<long double>(entry(it.value())) * scale;
      sum[it.col()] += value * z[n + i];
      sum[n + i] += value * z[it.col()];
    }
  }
  return sum;
}

template <class Entry>
Extended product(const ScaledSystem& scaled, const Eigen::VectorXd& z, const Entry& entry) {
  const LinearSystem& system = scaled.system();
  const Eigen::VectorXd x = scaled.unknowns(z);
  Extended result = with_constraints(block_product<long double>(system.stiffness, x, entry),
                                     system.constraints, scaled.scale(), z, entry);
  if (!system.rows.is_distributed()) return result;
  Extended head = result.head(x.size()), tail = result.tail(result.size() - x.size());
  system.rows.sum(head);
  system.multiplier_rows.sum(tail);
  result << head, tail;
  return result;
}

}  // namespace

ScaledSystem::ScaledSystem(const LinearSystem& system, const Eigen::VectorXd& load)
    : system_(system), load_(load) {
  const double mean = system.has_constraints() ? mean_diagonal(system.stiffness, system.rows) : 1;
  if (mean > 0) scale_ = std::exp2(std::round(std::log2(mean)));
  if (load_.size() > system.stiffness.rows()) load_.tail(system.constraints.rows()) *= scale_;
}

int ScaledSystem::rows() const {
  return system_.stiffness.rows() + static_cast<int>(system_.constraints.rows());
}

double ScaledSystem::norm(const Eigen::VectorXd& z) const {
  if (!system_.rows.is_distributed())
    return z.allFinite() ? z.stableNorm() : std::numeric_limits<double>::quiet_NaN();
  return std::hypot(system_.rows.norm(unknowns(z)),
                    system_.multiplier_rows.norm(z.tail(system_.constraints.rows())));
}

double ScaledSystem::load_norm() const {
  // One process may have f alone where others have g.
  if (system_.rows.is_distributed() && system_.has_constraints()) return norm(right_side());
  return load_.size() > system_.stiffness.rows() ? load_.stableNorm() : system_.rows.norm(load_);
}

Eigen::VectorXd ScaledSystem::right_side() const {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(rows());
  b.head(load_.size()) = load_;
  return b;
}

Eigen::VectorXd ScaledSystem::residual(const Eigen::VectorXd& z) const {
  Extended r = -product(*this, z, [](double value) { return value; });
  r.head(load_.size()) += load_.cast<long double>();
  return r.cast<double>();
}

double ScaledSystem::relative_residual(const Eigen::VectorXd& z) const {
  const double residual_norm = norm(residual(z));
  return residual_norm == 0 ? 0 : residual_norm / load_norm();
}

double ScaledSystem::rounding_level(const Eigen::VectorXd& z) const {
  Extended size = product(*this, z.cwiseAbs(), [](double value) { return std::abs(value); });
  size.head(load_.size()) += load_.cwiseAbs().cast<long double>();
  return std::numeric_limits<double>::epsilon() * norm(size.cast<double>()) / load_norm();
}

Eigen::VectorXd ScaledSystem::unknowns(const Eigen::VectorXd& z) const {
  return z.head(system_.stiffness.rows());
}

Eigen::VectorXd ScaledSystem::multipliers(const Eigen::VectorXd& z) const {
  return scale_ * z.tail(system_.constraints.rows());
}

Eigen::VectorXd ScaledSystem::join(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers) const {
  Eigen::VectorXd z(rows());
  z << x, multipliers / scale_;
  return z;
}

std::int64_t global_rows(const ScaledSystem& scaled) {
  const LinearSystem& system = scaled.system();
  const std::int64_t block_rows =
      system.rows.is_distributed() ? system.rows.global_rows() : system.stiffness.block_rows();
  return block_size * block_rows + system.constraint_count();
}

namespace {

// Place of every row of this process in the whole system, counted from `first`.
std::vector<int> places(const ScaledSystem& scaled, int first) {
  const LinearSystem& system = scaled.system();
  if (global_rows(scaled) >= std::numeric_limits<int>::max())
    throw Error(
        ErrorCode::unsupported,
        fmt::format("{} unknowns and multipliers are more than this solver's 32-bit numbers can count; "
                    "use method 'cholmod' with eliminated interfaces, or 'umfpack'",
                    global_rows(scaled)));
  std::vector<int> result(static_cast<std::size_t>(scaled.rows()));
  if (!system.rows.is_distributed()) {
    std::iota(result.begin(), result.end(), first);
    return result;
  }
  std::size_t next = 0;
  for (const int row : system.rows.global_of_local())
    for (int i = 0; i < block_size; ++i) result[next++] = first + block_size * row + i;
  for (const int row : system.multiplier_rows.global_of_local())
    result[next++] = first + block_size * system.rows.global_rows() + row;
  return result;
}

}  // namespace

MatrixEntries upper_entries(const ScaledSystem& scaled, int first) {
  const SymmetricBlockMatrix& stiffness = scaled.system().stiffness;
  const ConstraintMatrix& constraints = scaled.system().constraints;
  const std::vector<int> place = places(scaled, first);
  MatrixEntries entries;
  const auto count = static_cast<std::size_t>(block_entries * stiffness.blocks() -
                                              block_size * stiffness.block_rows() + constraints.nonZeros());
  entries.rows.reserve(count);
  entries.columns.reserve(count);
  entries.values.reserve(count);
  const auto append = [&](Eigen::Index row, Eigen::Index column, double value) {
    entries.rows.push_back(place[static_cast<std::size_t>(row)]);
    entries.columns.push_back(place[static_cast<std::size_t>(column)]);
    entries.values.push_back(value);
  };
  for (int row = 0; row < stiffness.rows(); ++row) {
    const int block_row = row / block_size, i = row % block_size;
    for (std::int64_t k = stiffness.row_start[block_row]; k < stiffness.row_start[block_row + 1]; ++k)
      for (int j = stiffness.columns[k] == block_row ? i : 0; j < block_size; ++j)
        append(row, block_size * Eigen::Index{stiffness.columns[k]} + j,
               stiffness.values[block_entries * k + block_size * i + j]);
  }
  for (Eigen::Index row = 0; row < constraints.rows(); ++row)
    for (ConstraintMatrix::InnerIterator it(constraints, row); it; ++it)
      append(it.col(), stiffness.rows() + row, scaled.scale() * it.value());
  return entries;
}

namespace {

// Entries on and above the diagonal, on one process.
CompressedRows<std::int64_t> upper_triangle(const ScaledSystem& scaled) {
  const SymmetricBlockMatrix& stiffness = scaled.system().stiffness;
  // Rows of B^T, so columns of B, stand to the right of K.
  const Eigen::SparseMatrix<double, Eigen::RowMajor> transposed = scaled.system().constraints.transpose();
  const std::int64_t constraint_rows = scaled.system().constraints.rows();
  const std::int64_t entries = block_entries * stiffness.blocks() - block_size * stiffness.block_rows() +
                               transposed.nonZeros() + constraint_rows;
  CompressedRows<std::int64_t> upper;
  upper.columns.reserve(entries);
  upper.values.reserve(entries);
  upper.row_start.reserve(scaled.rows() + 1);
  upper.row_start.push_back(0);
  const auto append = [&](std::int64_t column, double value) {
    upper.columns.push_back(column);
    upper.values.push_back(value);
  };
  for (int row = 0; row < stiffness.rows(); ++row) {
    const int block_row = row / block_size, i = row % block_size;
    for (std::int64_t k = stiffness.row_start[block_row]; k < stiffness.row_start[block_row + 1]; ++k)
      for (int j = stiffness.columns[k] == block_row ? i : 0; j < block_size; ++j)
        append(block_size * static_cast<std::int64_t>(stiffness.columns[k]) + j,
               stiffness.values[block_entries * k + block_size * i + j]);
    if (constraint_rows > 0)
      for (ConstraintMatrix::InnerIterator it(transposed, row); it; ++it)
        append(stiffness.rows() + it.col(), scaled.scale() * it.value());
    upper.row_start.push_back(static_cast<std::int64_t>(upper.columns.size()));
  }
  for (std::int64_t row = 0; row < constraint_rows; ++row) {
    append(stiffness.rows() + row, 0);  // solvers want every diagonal entry, also the zero ones
    upper.row_start.push_back(static_cast<std::int64_t>(upper.columns.size()));
  }
  return upper;
}

}  // namespace

CompressedRows<std::int64_t> full_matrix(const ScaledSystem& system) {
  const CompressedRows<std::int64_t> upper = upper_triangle(system);
  const std::int64_t n = system.rows();
  CompressedRows<std::int64_t> full;
  full.row_start.assign(n + 1, 0);
  for (std::int64_t row = 0; row < n; ++row)
    for (std::int64_t k = upper.row_start[row]; k < upper.row_start[row + 1]; ++k) {
      ++full.row_start[row + 1];
      if (upper.columns[k] != row) ++full.row_start[upper.columns[k] + 1];
    }
  for (std::int64_t row = 0; row < n; ++row) full.row_start[row + 1] += full.row_start[row];
  full.columns.resize(full.row_start[n]);
  full.values.resize(full.row_start[n]);
  std::vector<std::int64_t> next(full.row_start.begin(), full.row_start.end() - 1);
  const auto put = [&](std::int64_t row, std::int64_t column, double value) {
    full.columns[next[row]] = column;
    full.values[next[row]++] = value;
  };
  // Row by row, every mirrored entry arrives before the row's own ones: columns increase.
  for (std::int64_t row = 0; row < n; ++row)
    for (std::int64_t k = upper.row_start[row]; k < upper.row_start[row + 1]; ++k) {
      put(row, upper.columns[k], upper.values[k]);
      if (upper.columns[k] != row) put(upper.columns[k], row, upper.values[k]);
    }
  return full;
}

}  // namespace isopatch::solvers
