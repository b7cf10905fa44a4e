#include "segmentation/parameterization/internal/coons.hpp"

namespace isopatch::segmentation {
namespace {

std::vector<double> greville_shares(const geometry::KnotVector& knots) {
  std::vector<double> result = knots.greville();
  for (double& g : result) g = (g - knots.first()) / knots.length();
  return result;
}

/// Columns of three coordinates or four.
template <int Rows>
using Columns = Eigen::Matrix<double, Rows, Eigen::Dynamic>;

template <int Rows>
Columns<Rows> blended(const std::array<geometry::KnotVector, 2>& knots, Columns<Rows> net) {
  const int n = knots[0].size(), m = knots[1].size();
  const auto s = greville_shares(knots[0]), t = greville_shares(knots[1]);
  const auto at = [&](int i, int j) { return net.col(i + n * j); };
  for (int j = 1; j + 1 < m; ++j)
    for (int i = 1; i + 1 < n; ++i) {
      const double x = s[static_cast<std::size_t>(i)], y = t[static_cast<std::size_t>(j)];
      net.col(i + n * j) = (1 - x) * at(0, j) + x * at(n - 1, j) + (1 - y) * at(i, 0) + y * at(i, m - 1) -
                           (1 - y) * ((1 - x) * at(0, 0) + x * at(n - 1, 0)) -
                           y * ((1 - x) * at(0, m - 1) + x * at(n - 1, m - 1));
    }
  return net;
}

template <int Rows>
Columns<Rows> blended(const std::array<geometry::KnotVector, 3>& knots, Columns<Rows> net) {
  const std::array<int, 3> n{knots[0].size(), knots[1].size(), knots[2].size()};
  const std::array shares{greville_shares(knots[0]), greville_shares(knots[1]), greville_shares(knots[2])};
  std::array<int, 3> i{};
  // The point with some of its indices moved to the ends; `ends` has two bits a direction: whether, and
  // which.
  const auto blend = [&](unsigned directions) {
    Eigen::Matrix<double, Rows, 1> sum = Eigen::Matrix<double, Rows, 1>::Zero();
    for (unsigned ends = 0; ends < 8; ++ends) {
      if ((ends & ~directions) != 0) continue;
      double weight = 1;
      std::array<int, 3> at = i;
      for (unsigned d = 0; d < 3; ++d) {
        if (!(directions >> d & 1)) continue;
        const double x = shares[d][static_cast<std::size_t>(i[d])];
        const bool high = ends >> d & 1;
        weight *= high ? x : 1 - x;
        at[d] = high ? n[d] - 1 : 0;
      }
      sum += weight * net.col(at[0] + n[0] * (at[1] + n[1] * at[2]));
    }
    return sum;
  };
  for (i[2] = 1; i[2] + 1 < n[2]; ++i[2])
    for (i[1] = 1; i[1] + 1 < n[1]; ++i[1])
      for (i[0] = 1; i[0] + 1 < n[0]; ++i[0])
        net.col(i[0] + n[0] * (i[1] + n[1] * i[2])) =
            blend(1) + blend(2) + blend(4) - blend(3) - blend(5) - blend(6) + blend(7);
  return net;
}

/// Whether a column of a net lies inside it.
template <std::size_t D>
bool is_inner(const std::array<geometry::KnotVector, D>& knots, Eigen::Index column) {
  for (const geometry::KnotVector& along : knots) {
    const Eigen::Index i = column % along.size();
    if (i == 0 || i + 1 == along.size()) return false;
    column /= along.size();
  }
  return true;
}

template <std::size_t D>
RationalNet rational_blend(const std::array<geometry::KnotVector, D>& knots, RationalNet net) {
  for (Eigen::Index i = 0; i < net.weights.size(); ++i)
    if (is_inner(knots, i)) net.weights[i] = 1;
  if (!net.is_rational()) {
    net.points = blended<3>(knots, std::move(net.points));
    return net;
  }
  const Eigen::Matrix4Xd found = blended<4>(knots, net.homogeneous());
  for (Eigen::Index i = 0; i < found.cols(); ++i) {
    if (!is_inner(knots, i)) continue;
    net.weights[i] = found(3, i);
    net.points.col(i) = found.col(i).head<3>() / found(3, i);
  }
  return net;
}

}  // namespace

Eigen::Matrix3Xd coons_net(const std::array<geometry::KnotVector, 2>& knots, Eigen::Matrix3Xd net) {
  return blended<3>(knots, std::move(net));
}

Eigen::Matrix3Xd coons_net(const std::array<geometry::KnotVector, 3>& knots, Eigen::Matrix3Xd net) {
  return blended<3>(knots, std::move(net));
}

RationalNet coons_net(const std::array<geometry::KnotVector, 2>& knots, RationalNet net) {
  return rational_blend(knots, std::move(net));
}

RationalNet coons_net(const std::array<geometry::KnotVector, 3>& knots, RationalNet net) {
  return rational_blend(knots, std::move(net));
}

}  // namespace isopatch::segmentation
