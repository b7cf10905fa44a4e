#pragma once

#include <string>

#include "app/problem/build_problem.hpp"

namespace isopatch::app {

/// What `isopatch info` prints of a study besides its model: where its supports, loads and probes are.
/// @param all  every face; otherwise long lists are cut
std::string problem_text(const BuiltProblem& problem, bool all = false);

}  // namespace isopatch::app
