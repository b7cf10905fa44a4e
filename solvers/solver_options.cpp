#include "solvers/solver_options.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

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
    case Method::minres:
      return "minres";
  }
  return "unknown";
}

std::string_view name(Preconditioner preconditioner) {
  return preconditioner == Preconditioner::multigrid ? "multigrid" : "block_jacobi";
}

std::string_view name(Operator form) {
  switch (form) {
    case Operator::automatic:
      return "auto";
    case Operator::assembled:
      return "assembled";
    case Operator::matrix_free:
      return "matrix_free";
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
  const MultigridOptions& multigrid = options.multigrid;
  if (multigrid.smoothing_degree < 1 || multigrid.smoothing_degree > 20)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("solver smoothing_degree is {}; it must lie in 1 .. 20, for example 4",
                            multigrid.smoothing_degree));
  if (!(multigrid.smoothing_range >= 1.1 && multigrid.smoothing_range <= 1000))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("solver smoothing_range is {}; it must lie in [1.1, 1000], for example 40",
                            multigrid.smoothing_range));
  if (!(options.memory_limit >= 0))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("solver memory_limit is {} bytes; it must be positive, or 0 for what the machine has",
                    options.memory_limit));
}

}  // namespace isopatch::solvers
