#include "iga/solution/right_side.hpp"

#include "iga/coupling/idle_loads.hpp"
#include "iga/problem/loads.hpp"

namespace isopatch::iga {

RightSide right_side(const ElasticityProblem& problem, const GlobalNodes& global,
                     const std::vector<SupportFrame>& frames, int points) {
  RightSide result{load_vector(problem, points),
                   Eigen::Matrix3Xd(3, global.count()),
                   idle_loads(problem, global, frames),
                   {},
                   {},
                   {}};
  for (int c = 0; c < global.count(); ++c)
    result.prescribed.col(c) = frames[static_cast<std::size_t>(c)].prescribed;
  return result;
}

namespace {

void add_thermal(const RightSide& side, double factor, RightSide& sum) {
  if (side.thermal.empty()) return;
  if (sum.thermal.empty()) {
    sum.thermal.resize(side.thermal.size());
    sum.thermal_load = sum.thermal_ties = Eigen::Matrix3Xd::Zero(3, side.thermal_load.cols());
  }
  for (std::size_t p = 0; p < side.thermal.size(); ++p) {
    sum.thermal[p].at_origin += factor * side.thermal[p].at_origin;
    sum.thermal[p].gradient += factor * side.thermal[p].gradient;
  }
  sum.thermal_load += factor * side.thermal_load;
  sum.thermal_ties += factor * side.thermal_ties;
}

}  // namespace

RightSide combined(const std::vector<RightSide>& sides, const std::vector<double>& factors) {
  RightSide result{factors[0] * sides[0].load, factors[0] * sides[0].prescribed, {}, {}, {}, {}};
  for (std::size_t i = 1; i < factors.size(); ++i) {
    result.load += factors[i] * sides[i].load;
    result.prescribed += factors[i] * sides[i].prescribed;
  }
  for (std::size_t i = 0; i < factors.size(); ++i) add_thermal(sides[i], factors[i], result);
  return result;
}

}  // namespace isopatch::iga
