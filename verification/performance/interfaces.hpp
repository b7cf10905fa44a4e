#pragma once

#include <vector>

namespace isopatch::verification {

/// Registers what is measured on the link with patches none of which matches its neighbours: `link` (the
/// elements' stiffness, pattern and values), `interfaces` (what Nitsche's method adds to it) and `jumps` (the
/// integrals of mortar constraints). Counters: p, spans (the least along a direction of a patch; neighbours
/// have one or two more), omp_threads, dofs, elements, rational.
/// @param thread_counts  of OpenMP, each measured by itself
void register_interfaces(int degree, int spans, const std::vector<int>& thread_counts);

}  // namespace isopatch::verification
