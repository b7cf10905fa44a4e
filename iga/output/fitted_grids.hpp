#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "geometry/splines/grid.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::iga {

/// How exact straight cells shall be.
struct FitOptions {
  double tolerance = 0.01;            ///< of von Mises stress between nodes, of the largest, above 0
  std::int64_t most_cells = 400'000;  ///< of all patches, some 80 MB; grids that have more stay as they are
};

/// What came of it.
struct FitReport {
  double off = 0;  ///< estimated error of von Mises stress between nodes, of the largest, 0 .. 1
  int patch = -1;  ///< where it is so
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m
  std::int64_t cells = 0;                           ///< of all patches
};

/// Halves layers of cells where von Mises stress between nodes is too far from the solution's, on both sides
/// of every interface alike, so that patches go on to meet node by node.
///
/// Von Mises stress has a tip where stress nearly vanishes, as along a neutral axis: there linear
/// interpolation is off by the slope times the size of a cell, elsewhere by its square. So layers are halved
/// where the tip is, five times at most. If that makes too many cells, only the worst layers are halved; a
/// patch in which halving does not help, because a map that is nearly folded makes stress a pole, stays as it
/// is.
/// @param grids  of all patches; both ends of every element included, as many on both sides of an interface
/// @cost  every patch's fields once more, and those of changed patches once more each time
FitReport fit_grids(const ElasticField& field, const geometry::MultiPatch& model, const FitOptions& options,
                    std::vector<geometry::GridParameters<3>>& grids);

}  // namespace isopatch::iga
