// Threads that wait sleep, instead of taking a core from those that work.

#include <dlfcn.h>

#include <cstring>

namespace {

struct Setting {
  const char* name;
  const char* value;
};

// OpenMP's threads sleep at once. Those of OpenBLAS wait for 2^18 ticks of the clock, some 0.1 ms, about what
// waking them costs, since a factorization calls it again and again; by default they wait for 2^26.
constexpr Setting settings[] = {{"OMP_WAIT_POLICY", "passive"}, {"OPENBLAS_THREAD_TIMEOUT", "18"}};

}  // namespace

/// The environment as libraries see it: with the settings above where the user has made none.
///
/// libgomp and OpenBLAS read theirs once, while the program is loaded. Nothing of the program runs before
/// them: what DT_PREINIT_ARRAY sets is lost when libc takes over the environment. But they ask by this
/// function, and a program's own comes before libc's.
extern "C" char* getenv(const char* name) noexcept {
  static auto* const ask = reinterpret_cast<char* (*)(const char*)>(::dlsym(RTLD_NEXT, "getenv"));
  char* const found = ask(name);
  if (found != nullptr) return found;
  for (const Setting& setting : settings)
    if (std::strcmp(name, setting.name) == 0) return const_cast<char*>(setting.value);
  return nullptr;
}
