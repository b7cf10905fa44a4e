#include "geometry/tests/test_patches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/splines/refine.hpp"

namespace isopatch::geometry::test {

NurbsVolume mapped(const std::array<KnotVector, 3>& knots,
                   const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map) {
  std::vector<Eigen::Vector3d> points;
  for (const double w : knots[2].greville())
    for (const double v : knots[1].greville())
      for (const double u : knots[0].greville()) points.push_back(map({u, v, w}));
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = points[i];
  return NurbsVolume(knots, columns);
}

NurbsVolume box_between(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return mapped({},
                [&](const Eigen::Vector3d& t) { return Eigen::Vector3d(low + t.cwiseProduct(high - low)); });
}

namespace {

// Arcs of equal angle, end to end, each with its middle control point at the crossing of the end tangents.
NurbsVolume ring_of_arcs(double inner, double outer, double from, double to, double height, int arcs) {
  const double half = 0.5 * (to - from) / arcs;
  const KnotVector around = KnotVector::uniform(2, arcs, 2);
  Eigen::Matrix3Xd points(3, 4 * around.size());
  Eigen::VectorXd weights(4 * around.size());
  Eigen::Index i = 0;
  for (const double z : {0.0, height})
    for (int k = 0; k < around.size(); ++k)
      for (const double r : {inner, outer}) {
        const double angle = from + k * half;
        const double reach = k % 2 == 1 ? r / std::cos(half) : r;
        weights[i] = k % 2 == 1 ? std::cos(half) : 1;
        points.col(i++) << reach * std::cos(angle), reach * std::sin(angle), z;
      }
  return NurbsVolume({KnotVector(), around, KnotVector()}, points, weights);
}

}  // namespace

NurbsVolume ring_sector(double inner, double outer, double from, double to, double height) {
  return ring_of_arcs(inner, outer, from, to, height, 2);
}

NurbsVolume closed_ring(double inner, double outer, double height) {
  return ring_of_arcs(inner, outer, 0, 2 * std::numbers::pi, height, 4);
}

NurbsVolume permuted(const NurbsVolume& volume, const std::array<int, 3>& order,
                     const std::array<bool, 3>& flip) {
  const std::array<int, 3> stride = {1, volume.size(0), volume.size(0) * volume.size(1)};
  const auto at = [](int d) { return static_cast<std::size_t>(d); };
  std::array<KnotVector, 3> knots;
  std::array<int, 3> sizes;
  for (int d = 0; d < 3; ++d) {
    knots[at(d)] = volume.knots(order[at(d)]);
    sizes[at(d)] = knots[at(d)].size();
  }
  Eigen::Matrix3Xd points(3, volume.size());
  Eigen::VectorXd weights(volume.size());
  Eigen::Index i = 0;
  for (int c = 0; c < sizes[2]; ++c)
    for (int b = 0; b < sizes[1]; ++b)
      for (int a = 0; a < sizes[0]; ++a, ++i) {
        const int source = a * stride[at(order[0])] + b * stride[at(order[1])] + c * stride[at(order[2])];
        points.col(i) = volume.control_points().col(source);
        weights[i] = volume.weights()[source];
      }
  NurbsVolume result(knots, points, weights);
  for (int d = 0; d < 3; ++d)
    if (flip[at(d)]) result = reversed(result, d);
  return result;
}

NurbsVolume permuted(const NurbsVolume& volume, int index) {
  std::array<int, 3> order = {0, 1, 2};
  for (int i = 0; i < index / 8; ++i) std::next_permutation(order.begin(), order.end());
  return permuted(volume, order, {(index & 1) != 0, (index & 2) != 0, (index & 4) != 0});
}

std::vector<NurbsVolume> eight_boxes() {
  constexpr std::array<double, 3> x = {0, 1, 3};
  constexpr std::array<double, 3> y = {0, 2, 2.5};
  constexpr std::array<double, 3> z = {0, 0.7, 2};
  std::vector<NurbsVolume> boxes;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t i = 0; i < 2; ++i)
        boxes.push_back(box_between({x[i], y[j], z[k]}, {x[i + 1], y[j + 1], z[k + 1]}));
  return boxes;
}

}  // namespace isopatch::geometry::test
