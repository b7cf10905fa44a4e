#pragma once

#include <string>
#include <vector>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// Some of a problem's loads, which act together. Supports are common to all cases; what they prescribe acts
/// in some of them.
struct LoadCase {
  std::string name;
  std::vector<std::string> loads;            ///< names of surface and volume loads and temperatures
  std::vector<std::string> moving_supports;  ///< names of supports whose displacement acts; others hold at 0
};

/// A sum of cases, each with a factor.
struct LoadCombination {
  std::string name;
  std::vector<double> factors;  ///< one per case
};

/// The cases of a problem, then sums of them.
struct LoadCases {
  std::vector<LoadCase> cases;
  std::vector<LoadCombination> combinations = {};
};

/// The problem with the loads of one case alone.
/// @throws Error invalid_argument  a load or a support that the problem does not have
/// @cost   a copy of the discretization
ElasticityProblem of_case(const ElasticityProblem& problem, const LoadCase& load_case);

/// @throws Error invalid_argument  no case, names that are not all different, factors that are not one per
///     case or not finite
void validate(const LoadCases& cases);

}  // namespace isopatch::iga
