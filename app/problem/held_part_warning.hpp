#pragma once

#include <vector>

#include "app/base/warning.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::app {

/// A warning for every support that holds a part of faces rigidly in which no element fits: with the area
/// that is held in place of the part's.
std::vector<Warning> held_part_warnings(const iga::ElasticityProblem& problem);

}  // namespace isopatch::app
