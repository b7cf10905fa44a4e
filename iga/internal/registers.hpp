#pragma once

namespace isopatch::iga {

/// Doubles that one register of the processor compiled for holds.
constexpr int register_size =
#if defined(__AVX512F__)
    8;
#elif defined(__AVX__)
    4;
#else
    2;
#endif
/// So many doubles, with arithmetic entry by entry.
typedef double Register __attribute__((vector_size(8 * register_size)));
/// The same anywhere in an array of doubles.
typedef double UnalignedRegister __attribute__((vector_size(8 * register_size), aligned(8), may_alias));

/// `count` doubles rounded up to whole registers.
constexpr int padded(int count) {
  return (count + register_size - 1) / register_size * register_size;
}

inline __attribute__((always_inline)) Register load(const double* from) {
  return *reinterpret_cast<const UnalignedRegister*>(from);
}

inline __attribute__((always_inline)) void store(double* to, const Register& value) {
  *reinterpret_cast<UnalignedRegister*>(to) = value;
}

}  // namespace isopatch::iga
