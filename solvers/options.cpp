#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "solvers/solve.hpp"

namespace isopatch::solvers {

std::string_view name(Method method) {
  switch (method) {
    case Method::automatic:
      return "auto";
    case Method::cholmod:
      return "cholmod";
    case Method::mumps:
      return "mumps";
    case Method::umfpack:
      return "umfpack";
    case Method::cg:
      return "cg";
  }
  return "unknown";
}

void validate(const SolverOptions& options) {
  if (!(options.tolerance >= 1e-14 && options.tolerance <= 1e-2))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("solver tolerance is {}; it must lie in [1e-14, 1e-2], for example 1e-10",
                            options.tolerance));
  if (options.max_iterations < 1 || options.max_iterations > 10'000'000)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("solver max_iterations is {}; it must lie in 1 .. 10000000, for example 10000",
                            options.max_iterations));
}

}  // namespace isopatch::solvers
