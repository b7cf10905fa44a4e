#include "solvers/refinement.hpp"

#include <cmath>

#include "geometry/base/error.hpp"

namespace isopatch::solvers {
namespace {

void check_finite(const Eigen::VectorXd& z) {
  if (!z.allFinite())
    throw Error(ErrorCode::singular_system,
                "the factors gave values that are not finite: the matrix is singular to working precision");
}

}  // namespace

RefinedSolution solve_and_refine(const ScaledSystem& system, const ApplyInverse& inverse, double tolerance) {
  constexpr int most_steps = 10;
  const double load_norm = system.load_norm();
  RefinedSolution best{inverse(system.right_side()), {}};
  check_finite(best.z);
  Eigen::VectorXd residual = system.residual(best.z);
  best.history.push_back(system.norm(residual) / load_norm);
  for (int step = 1; step <= most_steps; ++step) {
    const double before = best.history.back();
    if (step > 1 && before <= tolerance) break;
    const Eigen::VectorXd z = best.z + inverse(residual);
    check_finite(z);
    residual = system.residual(z);
    const double after = system.norm(residual) / load_norm;
    // At the round-off level residuals waver, while the error of z may still shrink.
    if (after > before && after > tolerance) break;
    best.z = z;
    best.history.push_back(after);
    if (after > 0.5 * before) break;
  }
  return best;
}

}  // namespace isopatch::solvers
