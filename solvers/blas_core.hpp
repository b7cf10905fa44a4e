#pragma once

#include <string>
#include <string_view>

namespace isopatch::solvers {

/// What the kernels of OpenBLAS for x86-64 ask of a CPU.
struct CpuFeatures {
  bool avx2 = false;  ///< with FMA
  bool avx512 =
      false;  ///< foundation, conflict detection, byte and word, double and quad word, vector length
};
CpuFeatures cpu_features();

/// The core whose kernels suit a CPU better than those of `core`; empty if `core` is right or unknown.
///
/// OpenBLAS chooses its kernels by the model number, so a CPU that is newer than the library gets those of
/// the first 64-bit CPUs, several times slower.
std::string_view better_blas_core(std::string_view core, const CpuFeatures& features);

/// The core for which the BLAS computes ("SkylakeX"), empty if the BLAS is not OpenBLAS.
///
/// Programs with this library start with `better_blas_core` in use, unless OPENBLAS_CORETYPE is set, which
/// OpenBLAS honours itself.
std::string blas_core();

}  // namespace isopatch::solvers
