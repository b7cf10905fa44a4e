#include "solvers/zeroed_allocator.hpp"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace isopatch::solvers {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;  // bytes
constexpr std::size_t large = huge_page;                 // below, the usual heap does

// Whole huge pages: the system then puts the start at one too, and no part is left to small pages.
std::size_t mapped(std::size_t bytes) {
  return (bytes + huge_page - 1) / huge_page * huge_page;
}

}  // namespace

void* allocate_zeroed(std::size_t bytes) {
  if (bytes < large) {
    void* const memory = std::calloc(bytes > 0 ? bytes : 1, 1);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
  }
  void* const memory =
      mmap(nullptr, mapped(bytes), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  madvise(memory, mapped(bytes), MADV_HUGEPAGE);
#endif
  return memory;
}

void free_zeroed(void* memory, std::size_t bytes) noexcept {
  if (bytes < large)
    std::free(memory);
  else
    munmap(memory, mapped(bytes));
}

}  // namespace isopatch::solvers
