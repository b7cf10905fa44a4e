#include "solvers/zeroed_allocator.hpp"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace isopatch::solvers {
namespace {

constexpr std::size_t large = std::size_t{4} << 20;  // bytes; below, the usual heap does

}  // namespace

void* allocate_zeroed(std::size_t bytes) {
  if (bytes < large) {
    void* const memory = std::calloc(bytes > 0 ? bytes : 1, 1);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
  }
  void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  madvise(memory, bytes, MADV_HUGEPAGE);
#endif
  return memory;
}

void free_zeroed(void* memory, std::size_t bytes) noexcept {
  if (bytes < large)
    std::free(memory);
  else
    munmap(memory, bytes);
}

}  // namespace isopatch::solvers
