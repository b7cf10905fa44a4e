#pragma once

namespace isopatch::verification {

/// Registers what the machine itself can do, the limits that `register_kernels` is held against: `dgemm`
/// (each thread multiplies its own matrices with one BLAS thread), `triad` and `read` (streams through all
/// threads). Counters: omp_threads, flops or bytes of one iteration.
/// @param threads  of OpenMP
void register_limits(int threads);

}  // namespace isopatch::verification
