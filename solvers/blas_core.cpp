#include "solvers/blas_core.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "solvers/internal/blas_symbol.hpp"

namespace isopatch::solvers {
namespace {

constexpr const char* variable = "OPENBLAS_CORETYPE";

// OpenBLAS reads the variable when it is loaded. Two functions of its own let it forget its choice and choose
// again; no call of the BLAS leaves anything behind that depends on it.
bool choose_again() {
  const std::string better(better_blas_core(blas_core(), cpu_features()));
  auto* const forget = blas_function<void()>("gotoblas_dynamic_quit");
  auto* const choose = blas_function<void()>("gotoblas_dynamic_init");
  if (better.empty() || forget == nullptr || choose == nullptr || std::getenv(variable) != nullptr)
    return false;
  ::setenv(variable, better.c_str(), 0);
  forget();
  choose();
  ::unsetenv(variable);
  return true;
}

// Before main, when no other thread computes or reads the environment.
[[maybe_unused]] const bool chosen_again = choose_again();

}  // namespace

void* blas_symbol(const char* name) {
  return ::dlsym(RTLD_DEFAULT, name);
}

CpuFeatures cpu_features() {
#ifdef __x86_64__
  __builtin_cpu_init();
  CpuFeatures features;
  features.avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  features.avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                    __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
  return features;
#else
  return {};
#endif
}

std::string_view better_blas_core(std::string_view core, const CpuFeatures& features) {
  // Those without AVX2 among which OpenBLAS falls back.
  constexpr std::array<std::string_view, 7> old = {"Prescott", "Core2",     "Penryn",     "Dunnington",
                                                   "Nehalem",  "Barcelona", "Sandybridge"};
  if (std::find(old.begin(), old.end(), core) == old.end()) return {};
  if (features.avx512 && features.avx2) return "SkylakeX";
  return features.avx2 ? "Haswell" : "";
}

std::string blas_core() {
  auto* const name = blas_function<char*()>("openblas_get_corename");
  return name == nullptr ? "" : name();
}

}  // namespace isopatch::solvers
