#include "solvers/chebyshev.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "solvers/block_size.hpp"

namespace isopatch::solvers {
namespace {

// Numbers between -1 and 1 without a pattern, the same for a row on whichever process it is.
Eigen::VectorXd rough_vector(const SharedRows& rows) {
  Eigen::VectorXd x(block_size * static_cast<Eigen::Index>(rows.local_rows()));
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    auto bits = static_cast<std::uint64_t>(
        block_size *
            static_cast<std::int64_t>(rows.global_of_local()[static_cast<std::size_t>(i / block_size)]) +
        i % block_size);
    bits = (bits + 1) * 0x9E3779B97F4A7C15U;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBU;
    x[i] = 2 * static_cast<double>(bits >> 11) / 9007199254740992.0 - 1;
  }
  return x;
}

double largest_of_tridiagonal(const std::vector<double>& alpha, const std::vector<double>& beta) {
  const auto n = static_cast<Eigen::Index>(alpha.size());
  Eigen::VectorXd diagonal(n);
  Eigen::VectorXd beside(n - 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    diagonal[i] = 1 / alpha[k] + (i > 0 ? beta[k - 1] / alpha[k - 1] : 0);
    if (i + 1 < n) beside[i] = std::sqrt(beta[k]) / alpha[k];
  }
  return tridiagonal_eigen(diagonal, beside).values[n - 1];
}

// Of a vector, or of each column of a matrix.
template <class Vectors, class Product, class Preconditioner>
Vectors chebyshev_steps(const Product& product, const Preconditioner& preconditioner, const Vectors& b,
                        const ChebyshevInterval& interval) {
  const double middle = 0.5 * (interval.high + interval.low);
  const double half = 0.5 * (interval.high - interval.low);
  double rho = half / middle;
  Vectors step = preconditioner(b) / middle;
  Vectors x = step;
  Vectors residual = b;
  for (int k = 1; k < interval.degree; ++k) {
    residual -= product(step);
    const double next = 1 / (2 * middle / half - rho);
    step = (next * rho) * step + (2 * next / half) * preconditioner(residual);
    rho = next;
    x += step;
  }
  return x;
}

}  // namespace

Eigen::VectorXd chebyshev(const VectorsOperator& product, const VectorsOperator& preconditioner,
                          const Eigen::VectorXd& b, const ChebyshevInterval& interval) {
  return chebyshev_steps(product, preconditioner, b, interval);
}

Eigen::MatrixXd chebyshev_of_each(const VectorsOperator& product, const VectorsOperator& preconditioner,
                                  const Eigen::MatrixXd& b, const ChebyshevInterval& interval) {
  return chebyshev_steps([&](const Eigen::MatrixXd& x) { return product.of_each(x); },
                         [&](const Eigen::MatrixXd& r) { return preconditioner.of_each(r); }, b, interval);
}

double largest_eigenvalue(const VectorsOperator& product, const VectorsOperator& preconditioner,
                          const SharedRows& rows, int steps) {
  Eigen::VectorXd residual = product(rough_vector(rows));
  Eigen::VectorXd preconditioned = preconditioner(residual);
  Eigen::VectorXd direction = preconditioned;
  double rz = rows.dot(residual, preconditioned);
  const double first = rz;
  std::vector<double> alpha;
  std::vector<double> beta;
  for (int k = 0; k < steps && !(rz <= 1e-20 * first); ++k) {
    const Eigen::VectorXd image = product(direction);
    const double energy = rows.dot(direction, image);
    if (!(energy > 0) || !(rz > 0))
      throw Error(
          ErrorCode::singular_system,
          fmt::format("the matrix or its preconditioner is not positive definite (energy {:.3g} in step "
                      "{})",
                      energy, k));
    alpha.push_back(rz / energy);
    residual -= alpha.back() * image;
    preconditioned = preconditioner(residual);
    const double before = std::exchange(rz, rows.dot(residual, preconditioned));
    beta.push_back(std::max(0.0, rz / before));
    direction = preconditioned + beta.back() * direction;
  }
  return alpha.empty() ? 1.0 : largest_of_tridiagonal(alpha, beta);
}

}  // namespace isopatch::solvers
