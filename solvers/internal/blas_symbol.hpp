#pragma once

namespace isopatch::solvers {

/// Address of a function of the BLAS, null if it has none of that name. Looked up at run time: the BLAS is
/// whatever libblas.so.3 points to on the machine.
///
/// Defined in blas_core.cpp, so that whatever calls the BLAS has the core that is chosen there.
void* blas_symbol(const char* name);

template <class Function>
Function* blas_function(const char* name) {
  return reinterpret_cast<Function*>(blas_symbol(name));
}

}  // namespace isopatch::solvers
