#pragma once

#include <vector>

#include "iga/spaces/discretization.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/processes.hpp"

namespace isopatch::iga {

/// Energy and stress of an error in every element.
/// @param error      coefficients per node of `discretization`, (3, nodes), m
/// @param parts      the elements that this process integrates; those of all processes are all there are
/// @return           one per patch, the same on all processes
/// @cost  O((degree + 1)^4) per element, in parallel; the same for any number of threads
std::vector<ElementErrors> element_errors(const Discretization& discretization,
                                          const std::vector<Material>& materials,
                                          const Eigen::Matrix3Xd& error,
                                          const std::vector<PatchLayers>& parts,
                                          const solvers::Processes& processes);

}  // namespace isopatch::iga
