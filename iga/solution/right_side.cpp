#include "iga/solution/right_side.hpp"

#include "iga/coupling/idle_loads.hpp"
#include "iga/problem/loads.hpp"

namespace isopatch::iga {

RightSide right_side(const ElasticityProblem& problem, const GlobalNodes& global,
                     const std::vector<SupportFrame>& frames, int points) {
  RightSide result{load_vector(problem, points), Eigen::Matrix3Xd(3, global.count()),
                   idle_loads(problem, global, frames)};
  for (int c = 0; c < global.count(); ++c)
    result.prescribed.col(c) = frames[static_cast<std::size_t>(c)].prescribed;
  return result;
}

RightSide combined(const std::vector<RightSide>& sides, const std::vector<double>& factors) {
  RightSide result{factors[0] * sides[0].load, factors[0] * sides[0].prescribed, {}};
  for (std::size_t i = 1; i < factors.size(); ++i) {
    result.load += factors[i] * sides[i].load;
    result.prescribed += factors[i] * sides[i].prescribed;
  }
  return result;
}

}  // namespace isopatch::iga
