#include "solvers/blas_threads.hpp"

#include <omp.h>

#include "solvers/internal/blas_symbol.hpp"

namespace isopatch::solvers {
bool set_blas_threads(int count) {
  static auto* const set = blas_function<void(int)>("openblas_set_num_threads");
  if (set) set(count);
  return set != nullptr;
}

int blas_threads() {
  static auto* const get = blas_function<int()>("openblas_get_num_threads");
  return get ? get() : 0;
}

BlasThreads::BlasThreads() : before_(blas_threads()) {
  if (before_ > 0) set_blas_threads(omp_get_max_threads());
}

BlasThreads::~BlasThreads() {
  if (before_ > 0) set_blas_threads(before_);
}

}  // namespace isopatch::solvers
