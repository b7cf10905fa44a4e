#pragma once

#include "geometry/base/progress.hpp"
#include "solvers/linear_system.hpp"

namespace isopatch::solvers {

/// The largest and the smallest absolute eigenvalue of a system: of K, or with constraints of
/// [[K, s B^T], [s B, 0]] with s the mean of |diag K|, which is the matrix that is factorized.
struct ConditionEstimate {
  double largest = 0;
  double smallest = 0;
  double number() const { return largest / smallest; }
};

/// Estimates the condition number in the 2-norm by Lanczos' method, from products and from solutions.
///
/// Both values come from inside the spectrum, so the number is never too large by more than round-off;
/// measured against dense eigenvalues, it is less than one part in ten thousand too small.
///
/// @throws Error           whatever `solve` throws
/// @throws Error unsupported  on several processes
/// @cost   60 products and 30 direct solutions, each with a factorization of its own
/// @source Golub, Van Loan, Matrix Computations, section 10.1
ConditionEstimate estimate_condition(const LinearSystem& system, const Progress& progress = {});

}  // namespace isopatch::solvers
