#include "solvers/block_cg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::solvers {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Share of the tolerance to iterate to, for the true residual is not quite the updated one.
constexpr double margin = 0.8;
// Directions of length 1 that leave this share of energy beside the others are combinations of them.
constexpr double least_energy = 1e-12;

// Directions that are orthonormal in A, and A times them.
struct Directions {
  MatrixXd p, ap;
};

Directions orthonormal(const MatrixXd& p, const VectorsOperator& product, int step) {
  const MatrixXd ap = product.of_each(p);
  const MatrixXd energies = p.transpose() * ap;
  const SymmetricEigen parts = symmetric_eigen(0.5 * (energies + energies.transpose()));
  const double largest = parts.values[parts.values.size() - 1];
  if (!(largest > 0) || parts.values[0] < -1e-8 * largest)
    throw Error(ErrorCode::singular_system,
                fmt::format("the iteration met a direction without positive energy in step {}: the matrix is "
                            "singular or indefinite",
                            step));
  Index first = 0;
  while (parts.values[first] <= least_energy * largest) ++first;
  const Index count = parts.values.size() - first;
  const MatrixXd mix =
      parts.vectors.rightCols(count) * parts.values.tail(count).cwiseSqrt().cwiseInverse().asDiagonal();
  return {p * mix, ap * mix};
}

// Columns of a matrix, those of the loads that still iterate.
MatrixXd chosen(const MatrixXd& all, const std::vector<Index>& columns) {
  return all(Eigen::all, columns);
}

class Iteration {
 public:
  Iteration(const OperatorSystem& system, const MatrixXd& loads, const MatrixXd& preconditioned)
      : system_(&system),
        r_(loads),
        z_(preconditioned),
        x_(MatrixXd::Zero(loads.rows(), loads.cols())),
        first_(r_.cwiseProduct(z_).colwise().sum().transpose().cwiseSqrt()),
        error_(VectorXd::Ones(loads.cols())),
        errors_(static_cast<std::size_t>(loads.cols()), {1.0}) {
    for (Index j = 0; j < loads.cols(); ++j) left_.push_back(j);
  }

  void run(const SolverOptions& options, const Progress& progress) {
    for (int step = 1; step <= options.max_iterations && !left_.empty(); ++step) {
      advance(step);
      std::vector<Index> still;
      for (const Index j : left_) {
        errors_[static_cast<std::size_t>(j)].push_back(error_[j]);
        if (!(error_[j] <= margin * options.tolerance)) still.push_back(j);
      }
      left_ = std::move(still);
      progress("iterations",
               std::clamp(std::log(error_.maxCoeff()) / std::log(margin * options.tolerance), 0.0, 1.0));
    }
  }

  BlockSolution solution() { return {std::move(x_), std::move(errors_)}; }

 private:
  void advance(int step) {
    // Of length 1, so that no load's are small beside another's.
    MatrixXd p = chosen(z_, left_);
    if (before_.p.cols() > 0) p -= before_.p * (before_.ap.transpose() * p);
    for (Index k = 0; k < p.cols(); ++k) {
      const Index j = left_[static_cast<std::size_t>(k)];
      p.col(k) /= error_[j] * first_[j];
    }
    before_ = orthonormal(p, system_->product, step);
    const MatrixXd along = before_.p.transpose() * chosen(r_, left_);
    const MatrixXd dx = before_.p * along, dr = before_.ap * along;
    for (Index k = 0; k < dx.cols(); ++k) {
      const Index j = left_[static_cast<std::size_t>(k)];
      x_.col(j) += dx.col(k);
      r_.col(j) -= dr.col(k);
    }
    const MatrixXd z = system_->preconditioner.of_each(chosen(r_, left_));
    for (Index k = 0; k < dx.cols(); ++k) {
      const Index j = left_[static_cast<std::size_t>(k)];
      z_.col(j) = z.col(k);
      error_[j] = std::sqrt(std::max(0.0, r_.col(j).dot(z_.col(j)))) / first_[j];
    }
  }

  const OperatorSystem* system_;
  MatrixXd r_, z_, x_;
  VectorXd first_, error_;
  std::vector<std::vector<double>> errors_;
  std::vector<Index> left_;  // loads that still iterate
  Directions before_;
};

}  // namespace

BlockSolution solve_with_block_cg(const OperatorSystem& system, const MatrixXd& loads,
                                  const MatrixXd& preconditioned, const SolverOptions& options,
                                  const Progress& progress) {
  Iteration iteration(system, loads, preconditioned);
  iteration.run(options, progress);
  return iteration.solution();
}

}  // namespace isopatch::solvers
