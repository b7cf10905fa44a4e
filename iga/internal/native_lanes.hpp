#pragma once

namespace isopatch::iga {

/// Doubles in one vector register of the processor compiled for.
constexpr int native_lane_count =
#if defined(__AVX512F__)
    8;
#elif defined(__AVX__)
    4;
#else
    2;
#endif
/// A vector of `native_lane_count` doubles, with arithmetic entry by entry.
typedef double NativeLanes __attribute__((vector_size(8 * native_lane_count)));
/// The same without alignment, anywhere in an array of doubles.
typedef double UnalignedNativeLanes
    __attribute__((vector_size(8 * native_lane_count), aligned(8), may_alias));

/// `count` doubles rounded up to whole registers.
constexpr int padded(int count) {
  return (count + native_lane_count - 1) / native_lane_count * native_lane_count;
}

inline __attribute__((always_inline)) NativeLanes load(const double* from) {
  return *reinterpret_cast<const UnalignedNativeLanes*>(from);
}

inline __attribute__((always_inline)) void store(double* to, const NativeLanes& value) {
  *reinterpret_cast<UnalignedNativeLanes*>(to) = value;
}

}  // namespace isopatch::iga
