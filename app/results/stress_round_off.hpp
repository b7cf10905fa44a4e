#pragma once

#include "iga/post/elasticity_results.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::app {

/// What a stress must exceed to be more than round-off, Pa: a 10^-10 of Young's modulus (the largest) times
/// the largest displacement over the model's size. Iterations end at 10^-10 by default, and parts that move
/// as a whole have stresses of that size; in a sheet of 1:10,000 bending causes a 10^-4.
double stress_round_off(const iga::ElasticityProblem& problem, const iga::ElasticityResults& results);

}  // namespace isopatch::app
