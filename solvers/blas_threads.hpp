#pragma once

namespace isopatch::solvers {

/// Gives the BLAS all threads that OpenMP would use for as long as it lives, then the number it had before.
///
/// Does nothing with a BLAS other than OpenBLAS. Not to be made inside an OpenMP region.
class BlasThreads {
 public:
  BlasThreads();
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

 private:
  int before_ = 0;
};

/// Sets the number of threads the BLAS uses from now on. False, and without effect, if the BLAS is not
/// OpenBLAS.
bool set_blas_threads(int count);

/// Number of threads the BLAS uses, 0 if the BLAS is not OpenBLAS.
int blas_threads();

}  // namespace isopatch::solvers
