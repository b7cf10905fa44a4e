#pragma once

#include <cstddef>
#include <vector>

namespace isopatch::solvers {

/// Memory that reads as zero and is not touched before it is used.
/// @throws std::bad_alloc
void* allocate_zeroed(std::size_t bytes);
void free_zeroed(void* memory, std::size_t bytes) noexcept;

/// Allocator of numbers that start as zero without being written: the pages of a large array then belong to
/// the threads that fill it, and appear when they do, in parallel and as huge pages where the system has
/// them.
template <class T>
struct ZeroedAllocator {
  using value_type = T;
  ZeroedAllocator() = default;
  template <class U>
  ZeroedAllocator(const ZeroedAllocator<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_zeroed(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept { free_zeroed(memory, count * sizeof(T)); }
  /// Leaves a new element as the memory is.
  template <class U>
  void construct(U*) {}
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    *at = U(static_cast<Arguments&&>(arguments)...);
  }
  friend bool operator==(const ZeroedAllocator&, const ZeroedAllocator&) { return true; }
};

/// A vector whose elements are zero when it is made with a size; `resize` of a vector that was larger before
/// does not clear what it held.
template <class T>
using ZeroedVector = std::vector<T, ZeroedAllocator<T>>;

}  // namespace isopatch::solvers
