#include "app/base/exit_code.hpp"

namespace isopatch::app {

ExitCode exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::io:
      return ExitCode::file_problem;
    case ErrorCode::invalid_argument:
    case ErrorCode::bad_format:
    case ErrorCode::unsupported:
    case ErrorCode::not_conforming:
    case ErrorCode::not_manifold:
    case ErrorCode::not_contractible:
    case ErrorCode::not_three_connected:
    case ErrorCode::fold_over:
      return ExitCode::wrong_input;
    default:
      return ExitCode::failed;
  }
}

}  // namespace isopatch::app
