#pragma once

#include <stdexcept>
#include <string>

namespace isopatch {

/// Why something could not be done; the program maps each cause to its exit code.
enum class ErrorCode {
  invalid_argument,     ///< a value outside its range, a typo in a key
  io,                   ///< a file that cannot be read or written
  bad_format,           ///< a file whose content breaks its format
  unsupported,          ///< valid input that this version does not handle
  not_conforming,       ///< patches with a gap, an overlap or traces that do not match
  not_manifold,         ///< faces that do not bound a solid: open, overused or vanishing edges
  not_contractible,     ///< a solid with holes or cavities where one without is needed
  not_three_connected,  ///< an edge graph that two vertices cut apart, where that is not allowed
  fold_over,            ///< a patch whose Jacobian determinant is not positive
  free_body,            ///< supports that leave a rigid motion
  conflict,             ///< supports that contradict each other
  singular_system,      ///< a factorization met a zero or negative pivot
  not_converged,        ///< an iteration stopped above its tolerance
  out_of_memory,
  internal,  ///< a broken promise inside isopatch: a bug
};

/// Stable name of a code, for example "bad_format".
const char* name(ErrorCode code);

/// The only exception isopatch throws. The message says what, where and what to try.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace isopatch
