#include "solvers/residuals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "solvers/block_product.hpp"

namespace isopatch::solvers {
namespace {

// One row of some vectors.
template <std::size_t Count>
using Columns = std::array<double, Count>;

// Sums of some columns with the rounding errors that they left. This file is compiled without contraction of
// products and sums, which would take the errors for others.
template <std::size_t Count>
struct ExactSums {
  Columns<Count> high = {}, low = {};

  void add(double factor, const Columns<Count>& x) {
    for (std::size_t l = 0; l < Count; ++l) {
      const double sum = high[l] + factor * x[l];
      const double taken = sum - high[l];
      // What was lost of the sum before, and of the product, whose own rounding error is in it.
      low[l] += (high[l] - (sum - taken)) + std::fma(factor, x[l], -taken);
      high[l] = sum;
    }
  }
  void add(const ExactSums& other) {
    for (std::size_t l = 0; l < Count; ++l) add(l, other.high[l], other.low[l]);
  }
  // b minus the sum.
  double rest(std::size_t l, double b) const {
    ExactSums all;
    all.add(l, b, 0);
    all.add(l, -high[l], -low[l]);
    return all.high[l] + all.low[l];
  }

 private:
  void add(std::size_t l, double value, double error) {
    const double sum = high[l] + value;
    const double taken = sum - high[l];
    low[l] += ((high[l] - (sum - taken)) + (value - taken)) + error;
    high[l] = sum;
  }
};

template <std::size_t Count>
using Sums = std::vector<ExactSums<Count>>;

// The share of a range of rows and their mirror images, for the rows from its first on.
template <std::size_t Count>
Sums<Count> range_sums(const SymmetricBlockMatrix& matrix, const BlockRowRange& range,
                       const std::vector<Columns<Count>>& x) {
  Sums<Count> y(block_size * (static_cast<std::size_t>(range.last_column) + 1 - range.begin));
  for (int row = range.begin; row < range.end; ++row) {
    const Columns<Count>* const x_row = &x[block_size * static_cast<std::size_t>(row)];
    ExactSums<Count>* const y_row = &y[block_size * static_cast<std::size_t>(row - range.begin)];
    for (std::int64_t k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k) {
      const int column = matrix.columns[k];
      const double* const block = matrix.values.data() + block_entries * k;
      const Columns<Count>* const x_column = &x[block_size * static_cast<std::size_t>(column)];
      for (int i = 0; i < block_size; ++i)
        for (int j = 0; j < block_size; ++j) y_row[i].add(block[block_size * i + j], x_column[j]);
      if (column == row) continue;
      ExactSums<Count>* const y_column = &y[block_size * static_cast<std::size_t>(column - range.begin)];
      for (int i = 0; i < block_size; ++i)
        for (int j = 0; j < block_size; ++j) y_column[j].add(block[block_size * i + j], x_row[i]);
    }
  }
  return y;
}

// The result does not depend on the number of threads.
template <std::size_t Count>
Sums<Count> stiffness_product(const SymmetricBlockMatrix& matrix, const std::vector<Columns<Count>>& x) {
  const std::vector<BlockRowRange> ranges = balanced_ranges(matrix);
  std::vector<Sums<Count>> parts(ranges.size());
#pragma omp parallel for schedule(dynamic, 1) if (ranges.size() > 1)
  for (std::size_t i = 0; i < ranges.size(); ++i) parts[i] = range_sums(matrix, ranges[i], x);
  Sums<Count> y(static_cast<std::size_t>(matrix.rows()));
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ExactSums<Count>* const first = &y[block_size * static_cast<std::size_t>(ranges[i].begin)];
    for (std::size_t k = 0; k < parts[i].size(); ++k) first[k].add(parts[i][k]);
  }
  return y;
}

// s B^T y and s B x, as rows of the stiffness and behind them.
template <std::size_t Count>
void add_constraints(const ConstraintMatrix& constraints, double scale, const std::vector<Columns<Count>>& x,
                     std::size_t first, Sums<Count>& sums) {
  for (Eigen::Index i = 0; i < constraints.rows(); ++i) {
    const std::size_t multiplier = first + static_cast<std::size_t>(i);
    for (ConstraintMatrix::InnerIterator it(constraints, i); it; ++it) {
      // s is a power of 2, so the products with it are exact.
      const double value = it.value() * scale;
      const auto column = static_cast<std::size_t>(it.col());
      sums[column].add(value, x[multiplier]);
      sums[multiplier].add(value, x[column]);
    }
  }
}

// Those of up to `Count` columns from `first` on.
template <std::size_t Count>
void add_residuals(const std::vector<const ScaledSystem*>& systems, const Eigen::MatrixXd& z,
                   Eigen::Index first, Eigen::MatrixXd& result) {
  const ScaledSystem& scaled = *systems.front();
  const LinearSystem& system = scaled.system();
  const Eigen::Index count = std::min(static_cast<Eigen::Index>(Count), z.cols() - first);
  std::vector<Columns<Count>> x(static_cast<std::size_t>(z.rows()), Columns<Count>{});
  for (Eigen::Index l = 0; l < count; ++l)
    for (Eigen::Index i = 0; i < z.rows(); ++i)
      x[static_cast<std::size_t>(i)][static_cast<std::size_t>(l)] = z(i, first + l);
  Sums<Count> sums = stiffness_product(system.stiffness, x);
  const auto rows = sums.size();
  sums.resize(x.size());
  add_constraints(system.constraints, scaled.scale(), x, rows, sums);
  for (Eigen::Index l = 0; l < count; ++l) {
    const Eigen::VectorXd& load = systems[static_cast<std::size_t>(first + l)]->load();
    for (Eigen::Index i = 0; i < z.rows(); ++i)
      result(i, first + l) = sums[static_cast<std::size_t>(i)].rest(static_cast<std::size_t>(l),
                                                                    i < load.size() ? load[i] : 0.0);
  }
}

}  // namespace

Eigen::MatrixXd residuals(const std::vector<const ScaledSystem*>& systems, const Eigen::MatrixXd& z) {
  Eigen::MatrixXd result(z.rows(), z.cols());
  if (z.cols() == 1 || systems.front()->system().rows.is_distributed()) {
    for (Eigen::Index k = 0; k < z.cols(); ++k)
      result.col(k) = systems[static_cast<std::size_t>(k)]->residual(z.col(k));
    return result;
  }
  constexpr Eigen::Index most = 8, few = 2;
  for (Eigen::Index first = 0; first < z.cols(); first += most)
    if (z.cols() - first <= few)
      add_residuals<few>(systems, z, first, result);
    else
      add_residuals<most>(systems, z, first, result);
  // What is too large for a double may not be for an extended number.
  for (Eigen::Index k = 0; k < z.cols(); ++k)
    if (!result.col(k).allFinite()) result.col(k) = systems[static_cast<std::size_t>(k)]->residual(z.col(k));
  return result;
}

}  // namespace isopatch::solvers
