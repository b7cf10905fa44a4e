#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "iga/assembly/internal/side_grid.hpp"

namespace isopatch::iga {

/// Row by row.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The pairs of functions, one of each of two sets, that are both not 0 at some point of a line.
class FunctionPairs {
 public:
  FunctionPairs(const LineTable& first, const LineTable& second);

  std::size_t size() const { return pairs_.size(); }
  const std::array<int, 2>& operator[](std::size_t pair) const { return pairs_[pair]; }
  /// The number of a pair; -1 for those that never meet.
  int find(int first, int second) const { return numbers_(first, second); }
  /// (pairs, points) of products of values, or derivatives, of the two at the points.
  LineTable products(const LineTable& first, const LineTable& second) const;

 private:
  std::vector<std::array<int, 2>> pairs_;
  Eigen::MatrixXi numbers_;
};

/// Numbers at the points of a grid, one field after the other: field f at (i, j) is in row i and column
/// f * (points of direction 1) + j.
struct GridFields {
  Rows values;
  Eigen::Index count = 0;

  GridFields(Eigen::Index points_0, Eigen::Index points_1, Eigen::Index fields)
      : values(points_0, fields * points_1), count(fields) {}
  double& at(Eigen::Index field, Eigen::Index i, Eigen::Index j) {
    return values(i, field * (values.cols() / count) + j);
  }
};

/// For all pairs of functions along direction 0 and along direction 1 the sum over the grid's points of the
/// products of all four with each field, by one direction after the other.
/// @param pairs_0, pairs_1  (pairs, points) of direction 0 and 1
/// @return  (pairs of direction 1, fields * pairs of direction 0)
/// @cost    2 fields * pairs_0 * points of a pair * (points_1 + pairs_1) flops
Rows grid_integrals(const LineTable& pairs_0, const LineTable& pairs_1, const GridFields& fields);

}  // namespace isopatch::iga
