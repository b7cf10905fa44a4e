#pragma once

#include <string>
#include <vector>

#include "app/pages/page.hpp"
#include "app/verify/verified_claim.hpp"

namespace isopatch::app {

/// Errors over the size of the elements, logarithmic, for every order of convergence among the claims: those
/// of one test that measure the same are lines of one plot, eight at most, each with the measured slope
/// beside the expected one.
///
/// @return  plots whose section is the suite's name, in the order of the claims
std::vector<PagePlot> verification_plots(const std::vector<VerifiedClaim>& claims);

}  // namespace isopatch::app
