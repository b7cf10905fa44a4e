#include "geometry/determinant_bounds.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace isopatch::geometry {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Sum over all permutations of the products of entries.
double permanent(const Eigen::Matrix3d& m) {
  return m(0, 0) * (m(1, 1) * m(2, 2) + m(1, 2) * m(2, 1)) +
         m(0, 1) * (m(1, 0) * m(2, 2) + m(1, 2) * m(2, 0)) +
         m(0, 2) * (m(1, 0) * m(2, 1) + m(1, 1) * m(2, 0));
}

double permanent(const Eigen::Matrix4d& m) {
  const auto pair = [&](int i, int j, int row) {
    return m(row, i) * m(row + 1, j) + m(row, j) * m(row + 1, i);
  };
  return pair(0, 1, 0) * pair(2, 3, 2) + pair(0, 2, 0) * pair(1, 3, 2) + pair(0, 3, 0) * pair(1, 2, 2) +
         pair(1, 2, 0) * pair(0, 3, 2) + pair(1, 3, 0) * pair(0, 2, 2) + pair(2, 3, 0) * pair(0, 1, 2);
}

/// Of a matrix that lies within `half` of `centre`, which is nearly the unit matrix: the diagonal's product,
/// and all other products as they may come.
template <int N>
Bounds near_unit(const Eigen::Matrix<double, N, N>& centre, const Eigen::Matrix<double, N, N>& half) {
  const Eigen::Matrix<double, N, N> largest = centre.cwiseAbs() + half;
  const Eigen::Matrix<double, N, 1> low = centre.diagonal() - half.diagonal(), high = largest.diagonal();
  const double all = permanent(largest);
  if (!(low.minCoeff() > 0)) return {-all, all};
  const double others = all - high.prod() + 64 * unit_roundoff * all;
  return {low.prod() - others, high.prod() + others};
}

/// Bounds of det M from those of det(B M).
template <int N>
Bounds divided(const Bounds& scaled, const Eigen::Matrix<double, N, N>& b) {
  const double determinant = b.determinant();
  const double error = 64 * unit_roundoff * permanent(b.cwiseAbs().eval());
  const double least = std::abs(determinant) - error, most = std::abs(determinant) + error;
  if (!(least > 0)) return {-infinity, infinity};
  const Bounds absolute{scaled.low / (scaled.low > 0 ? most : least),
                        scaled.high / (scaled.high > 0 ? least : most)};
  return determinant > 0 ? absolute : Bounds{-absolute.high, -absolute.low};
}

}  // namespace

template <int N>
Bounds determinant_bounds(const ColumnBoxes<N>& columns) {
  using Square = Eigen::Matrix<double, N, N>;
  // Any matrix will do, the inverse is only the best.
  const Square inverse = columns.centre.inverse();
  if (!inverse.allFinite()) return {-infinity, infinity};
  const Square magnitude = inverse.cwiseAbs();
  const Square half = magnitude * columns.half + 16 * unit_roundoff * (magnitude * columns.centre.cwiseAbs());
  return divided<N>(near_unit<N>(inverse * columns.centre, half), inverse);
}

template <int N>
Bounds determinant_bounds(const std::array<Eigen::Matrix<double, N, Eigen::Dynamic>, N>& hulls,
                          const std::array<double, N>& errors) {
  using Square = Eigen::Matrix<double, N, N>;
  Square centre;
  for (int k = 0; k < N; ++k) {
    const auto& hull = hulls[static_cast<std::size_t>(k)];
    centre.col(k) = (hull.rowwise().minCoeff() + hull.rowwise().maxCoeff()) / 2;
  }
  const Square inverse = centre.inverse();
  if (!inverse.allFinite()) return {-infinity, infinity};
  const Square magnitude = inverse.cwiseAbs();
  ColumnBoxes<N> boxes;
  for (int k = 0; k < N; ++k) {
    const auto& hull = hulls[static_cast<std::size_t>(k)];
    const Eigen::Matrix<double, N, Eigen::Dynamic> turned = inverse * hull;
    const Eigen::Matrix<double, N, 1> low = turned.rowwise().minCoeff(), high = turned.rowwise().maxCoeff();
    boxes.centre.col(k) = (low + high) / 2;
    boxes.half.col(k) =
        (high - low) / 2 +
        magnitude * (16 * unit_roundoff * hull.cwiseAbs().rowwise().maxCoeff() +
                     Eigen::Matrix<double, N, 1>::Constant(errors[static_cast<std::size_t>(k)]));
  }
  return divided<N>(near_unit<N>(boxes.centre, boxes.half), inverse);
}

#define ISOPATCH_DETERMINANTS(N)                                                                        \
  template Bounds determinant_bounds<N>(const ColumnBoxes<N>&);                                         \
  template Bounds determinant_bounds<N>(const std::array<Eigen::Matrix<double, N, Eigen::Dynamic>, N>&, \
                                        const std::array<double, N>&)
ISOPATCH_DETERMINANTS(3);
ISOPATCH_DETERMINANTS(4);
#undef ISOPATCH_DETERMINANTS

}  // namespace isopatch::geometry
