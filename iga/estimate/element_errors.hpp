#pragma once

#include <vector>

#include "iga/spaces/discretization.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/processes.hpp"

namespace isopatch::iga {

/// Energy and stress of several errors in every element, and the energy's shares along the directions.
///
/// Along a direction of degree p the error of functions of degree p oscillates as the Legendre polynomial of
/// degree p in each element, if `discretization` is one degree above them. The squares of these parts, each
/// by the square of the direction's stretch, give the shares.
/// @param errors     coefficients per node of `discretization`, (3, nodes), m
/// @param parts      the elements that this process integrates; those of all processes are all there are
/// @return           of each error one per patch, the same on all processes
/// @cost  O((degree + 1)^4) per element and error, and once for the geometry, in parallel; the same for any
/// number of threads
std::vector<std::vector<ElementErrors>> element_errors(const Discretization& discretization,
                                                       const std::vector<Material>& materials,
                                                       const std::vector<Eigen::Matrix3Xd>& errors,
                                                       const std::vector<PatchLayers>& parts,
                                                       const solvers::Processes& processes);

}  // namespace isopatch::iga
