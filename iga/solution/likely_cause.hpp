#pragma once

#include <string>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// Gauss points per direction below which a motion may have no energy: degree + 1, the default.
/// @param points  Gauss points per element and direction; 0: degree + 1
bool has_too_few_points(const Discretization& discretization, int points);

/// What in a problem makes its matrix singular to working precision, or hard to solve, in words: too few
/// Gauss points, a Poisson's ratio near 0.5, materials of very different stiffness, thin patches; general
/// advice without any of these.
std::string likely_cause(const ElasticityProblem& problem, int points);

}  // namespace isopatch::iga
