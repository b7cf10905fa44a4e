#include "geometry/base/error.hpp"

namespace isopatch {

const char* name(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument:
      return "invalid_argument";
    case ErrorCode::io:
      return "io";
    case ErrorCode::bad_format:
      return "bad_format";
    case ErrorCode::unsupported:
      return "unsupported";
    case ErrorCode::not_conforming:
      return "not_conforming";
    case ErrorCode::not_manifold:
      return "not_manifold";
    case ErrorCode::not_contractible:
      return "not_contractible";
    case ErrorCode::not_three_connected:
      return "not_three_connected";
    case ErrorCode::fold_over:
      return "fold_over";
    case ErrorCode::free_body:
      return "free_body";
    case ErrorCode::conflict:
      return "conflict";
    case ErrorCode::singular_system:
      return "singular_system";
    case ErrorCode::not_converged:
      return "not_converged";
    case ErrorCode::out_of_memory:
      return "out_of_memory";
    case ErrorCode::internal:
      return "internal";
  }
  return "unknown";
}

}  // namespace isopatch
