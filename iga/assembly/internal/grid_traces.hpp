#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "geometry/shared_grid.hpp"
#include "iga/assembly/internal/side_grid.hpp"

namespace isopatch::iga {

/// The integrals of the splines of a face, without weights, with the functions of the two sides of an
/// interface, as entries (spline, node of all patches); splines with the first direction fastest.
struct TraceIntegrals {
  std::vector<Eigen::Triplet<double>> of_own;
  std::vector<Eigen::Triplet<double>> of_other;
};

/// By sum factorization, where both sides have the same lines of equal parameters.
/// @param own  the side whose splines are taken
/// @cost  about 4 (degree + 1) flops per entry
TraceIntegrals grid_traces(const SideFunctions& own, const SideFunctions& other,
                           const geometry::SharedGrid& grid);

}  // namespace isopatch::iga
