#include "verification/performance/limits.hpp"

#include <benchmark/benchmark.h>
#include <cblas.h>
#include <omp.h>

#include <memory>
#include <string>
#include <vector>

namespace isopatch::verification {
namespace {

// Large enough to reach the rate of large products, small enough to leave the second core its share of cache.
constexpr int dgemm_size = 1024;
// Three arrays of 128 MB each: beyond the last cache of most machines.
constexpr std::int64_t stream_length = 16 << 20;

// Zeroed by the threads that use it, so that its pages lie near them.
std::unique_ptr<double[]> stream(double value) {
  std::unique_ptr<double[]> data(new double[stream_length]);
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < stream_length; ++i) data[i] = value;
  return data;
}

void dgemm(benchmark::State& state, int threads) {
  omp_set_num_threads(threads);
  constexpr std::size_t entries = std::size_t{dgemm_size} * dgemm_size;
  std::vector<std::vector<double>> a(threads), b(threads), c(threads);
  for (int t = 0; t < threads; ++t) {
    a[t].assign(entries, 1.0 / 3);
    b[t].assign(entries, 2.0 / 3);
    c[t].assign(entries, 0);
  }
  for ([[maybe_unused]] auto _ : state) {
#pragma omp parallel num_threads(threads)
    {
      const int t = omp_get_thread_num();
      cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, dgemm_size, dgemm_size, dgemm_size, 1.0,
                  a[t].data(), dgemm_size, b[t].data(), dgemm_size, 0.0, c[t].data(), dgemm_size);
    }
    benchmark::ClobberMemory();
  }
  state.counters["omp_threads"] = threads;
  state.counters["flops"] = 2.0 * dgemm_size * dgemm_size * dgemm_size * threads;
}

void triad(benchmark::State& state, int threads) {
  omp_set_num_threads(threads);
  const auto first = stream(0), second = stream(1), third = stream(2);
  // Plain pointers, for loops that compilers turn into vector instructions.
  double* const a = first.get();
  const double* const b = second.get();
  const double* const c = third.get();
  for ([[maybe_unused]] auto _ : state) {
#pragma omp parallel for simd schedule(static)
    for (std::int64_t i = 0; i < stream_length; ++i) a[i] = b[i] + 3.0 * c[i];
    benchmark::ClobberMemory();
  }
  state.counters["omp_threads"] = threads;
  // As STREAM counts: without the line that a store first reads.
  state.counters["bytes"] = 3.0 * sizeof(double) * stream_length;
}

void read(benchmark::State& state, int threads) {
  omp_set_num_threads(threads);
  const auto values = stream(1);
  const double* const a = values.get();
  for ([[maybe_unused]] auto _ : state) {
    double sum = 0;
#pragma omp parallel for simd schedule(static) reduction(+ : sum)
    for (std::int64_t i = 0; i < stream_length; ++i) sum += a[i];
    benchmark::DoNotOptimize(sum);
  }
  state.counters["omp_threads"] = threads;
  state.counters["bytes"] = 1.0 * sizeof(double) * stream_length;
}

}  // namespace

void register_limits(int threads) {
  const std::string suffix = "/threads:" + std::to_string(threads);
  const auto measure = [&](const char* name, auto kernel) {
    benchmark::RegisterBenchmark((name + suffix).c_str(), kernel, threads)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  };
  measure("dgemm", dgemm);
  measure("triad", triad);
  measure("read", read);
}

}  // namespace isopatch::verification
