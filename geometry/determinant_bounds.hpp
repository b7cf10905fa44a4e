#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

namespace isopatch::geometry {

/// Relative rounding error of one operation.
constexpr double unit_roundoff = 0.5 * std::numeric_limits<double>::epsilon();

/// An interval.
struct Bounds {
  double low = 0;
  double high = 0;
};

/// Columns that lie in boxes: column k within `half.col(k)` of `centre.col(k)`, coordinate by coordinate.
template <int N>
struct ColumnBoxes {
  Eigen::Matrix<double, N, N> centre, half;
};

/// Bounds of det[a, b, ...] over all choices of one column from each box; rigorous, round-off included.
///
/// Sharp to second order in the boxes' widths where the columns' own changes stay within their directions;
/// infinite where the boxes are too wide to tell.
template <int N>
Bounds determinant_bounds(const ColumnBoxes<N>& columns);

/// Bounds of the determinant for columns from the convex hulls of vectors, as sharp as in the frame that fits
/// them best.
/// @param hulls   (N, any number) by column
/// @param errors  bound of a coordinate's error, by column
template <int N>
Bounds determinant_bounds(const std::array<Eigen::Matrix<double, N, Eigen::Dynamic>, N>& hulls,
                          const std::array<double, N>& errors);

}  // namespace isopatch::geometry
