#include "solvers/blas_threads.hpp"

#include <dlfcn.h>
#include <omp.h>

namespace isopatch::solvers {
namespace {

// Looked up at run time: the BLAS is whatever libblas.so.3 points to on the machine.
template <class Function>
Function* find(const char* symbol) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_DEFAULT, symbol));
}

}  // namespace

bool set_blas_threads(int count) {
  static auto* const set = find<void(int)>("openblas_set_num_threads");
  if (set) set(count);
  return set != nullptr;
}

int blas_threads() {
  static auto* const get = find<int()>("openblas_get_num_threads");
  return get ? get() : 0;
}

BlasThreads::BlasThreads() : before_(blas_threads()) {
  if (before_ > 0) set_blas_threads(omp_get_max_threads());
}

BlasThreads::~BlasThreads() {
  if (before_ > 0) set_blas_threads(before_);
}

}  // namespace isopatch::solvers
