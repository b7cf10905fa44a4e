#pragma once

#include <vector>

namespace isopatch::solvers {

/// The structure of a symmetric matrix, coarsened: vertices are groups of rows, and the rows of two groups
/// that share an edge are taken for coupled, each with each.
struct RowGroups {
  std::vector<int> rows;        ///< of each group
  std::vector<int> edge_start;  ///< per group, into `neighbours`, and their number at the end
  std::vector<int> neighbours;  ///< both ways, without the group itself

  int count() const { return static_cast<int>(rows.size()); }
};

/// What a factorization L L^T takes, diagonal included.
struct FactorForecast {
  double entries = 0;        ///< of L
  double flops = 0;          ///< additions and multiplications
  double largest_front = 0;  ///< entries of the largest dense block that a column group works on
};

/// Counts the factor of a matrix by symbolic elimination of its groups, in the better of two orders: METIS'
/// nested dissection and AMD.
///
/// Groups as wide as functions overlap keep separators as they are, so that the figures are near those of the
/// matrix itself at a small part of its cost (solvers/README.md, "What a factor takes").
///
/// @throws Error internal, out_of_memory  if the ordering fails
/// @cost   ordering, and O(entries of the groups' own factor)
/// @source Liu, The role of elimination trees in sparse factorization, 1990, sections 4 and 5
FactorForecast forecast_factor(const RowGroups& groups);

}  // namespace isopatch::solvers
