// Measures the kernels and the machine's limits in one run; scripts/bench calls it and reads its JSON.

#include <benchmark/benchmark.h>
#include <cblas.h>
#include <omp.h>

#include "solvers/blas_threads.hpp"
#include "verification/performance/interfaces.hpp"
#include "verification/performance/kernels.hpp"
#include "verification/performance/limits.hpp"

namespace isopatch::verification {
namespace {

void register_all() {
  std::vector<int> threads;
  for (int count = 1; count <= omp_get_num_procs(); count *= 2) threads.push_back(count);
  for (const int count : threads) register_limits(count);
  for (const bool rational : {false, true}) {
    register_kernels({2, 16, rational}, threads, true);
    register_kernels({3, 16, rational}, threads, true);
    register_kernels({4, 12, rational}, threads, true);
    register_kernels({3, 32, rational}, threads, false);
  }
  for (const int degree : {2, 3, 4}) register_interfaces(degree, 8, threads);
  register_interfaces(3, 16, threads);
}

}  // namespace
}  // namespace isopatch::verification

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  isopatch::solvers::set_blas_threads(1);
  benchmark::AddCustomContext("blas", openblas_get_config());
  benchmark::AddCustomContext("compiler", "GCC " __VERSION__);
  isopatch::verification::register_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
