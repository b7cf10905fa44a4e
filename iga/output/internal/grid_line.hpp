#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/splines/knot_vector.hpp"

namespace isopatch::iga {

/// Combinations of neighbouring coefficients along one direction of a patch, for the nodes of a grid: a node
/// has one, or two where derivatives jump, one from each side.
struct GridLine {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  std::vector<double> nodes;  ///< parameters
  std::vector<int> begin;     ///< combination of each node, and their number at the end
  std::vector<int> first;     ///< coefficient of each combination; degree + 1 follow
  Rows values;                ///< (combinations, degree + 1)
  Rows derivatives;           ///< likewise

  int size() const { return static_cast<int>(begin.size()) - 1; }
};

/// Values and derivatives at parameters, increasing. A node at a knot where the splines are not
/// differentiable has two combinations.
GridLine grid_line(const geometry::KnotVector& knots, const std::vector<double>& nodes);

/// The control points of the Bezier form, degree times the elements plus 1 of them; no derivatives.
GridLine bezier_line(const geometry::KnotVector& knots);

}  // namespace isopatch::iga
