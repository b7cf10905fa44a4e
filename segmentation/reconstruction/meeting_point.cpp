#include "segmentation/reconstruction/internal/meeting_point.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/base/dense_matrices.hpp"
#include "segmentation/reconstruction/internal/carrier_distance.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;

// Below this angle carriers touch, sin 0.6 degrees: fits of touching ones cross at less than 0.1.
constexpr double touching_sine = 0.01;
// Directions in which equations say less than this share of what they say in others are left free.
constexpr double weak = 1e-6;

/// Equations for a step: rows of unit length, lengths on the right.
struct StepEquations {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  void add(const Eigen::Vector3d& row, double value) {
    matrix += row * row.transpose();
    right -= value * row;
  }
  Eigen::Vector3d least_step() const {
    const auto [values, axes] = principal_axes(matrix);
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
      if (values[i] > weak * values[2]) step += axes.col(i) * axes.col(i).dot(right) / values[i];
    }
    return step;
  }
};

/// Where two carriers touch, their distances differ least: the difference's gradient vanishes across the line
/// of contact.
void add_contact(StepEquations& equations, const Carrier& a, const Carrier& b, const Eigen::Vector3d& point,
                 double size) {
  const Eigen::Vector3d normal = carrier_distance(a, point).gradient;
  const double side = normal.dot(carrier_distance(b, point).gradient) > 0 ? 1 : -1;
  const auto slope = [&](const Eigen::Vector3d& at) -> Eigen::Vector3d {
    return carrier_distance(a, at).gradient - side * carrier_distance(b, at).gradient;
  };
  const Eigen::Vector3d x = any_normal(normal), y = normal.cross(x), here = slope(point);
  const double step = 1e-5 * size;
  Eigen::Matrix2d bend;
  const Eigen::Vector3d by_x = (slope(point + step * x) - slope(point - step * x)) / (2 * step);
  const Eigen::Vector3d by_y = (slope(point + step * y) - slope(point - step * y)) / (2 * step);
  bend << by_x.dot(x), by_y.dot(x), by_x.dot(y), by_y.dot(y);
  const Eigen::Matrix2d even = (bend + bend.transpose()) / 2;
  const SymmetricEigen parts = symmetric_eigen(even);
  const double most = parts.values.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double value = parts.values[i];
    if (std::abs(value) * size < 1e-6 || std::abs(value) < 1e-3 * most) continue;
    const Eigen::Vector3d across = parts.vectors(0, i) * x + parts.vectors(1, i) * y;
    equations.add(across, here.dot(across) / value);
  }
}

}  // namespace

Eigen::Vector3d meeting_point(const std::vector<Carrier>& carriers, const Eigen::Vector3d& start,
                              double size) {
  Eigen::Vector3d point = start;
  for (int round = 0; round < 30; ++round) {
    StepEquations equations;
    std::vector<CarrierDistance> distances;
    for (const Carrier& carrier : carriers) {
      distances.push_back(carrier_distance(carrier, point));
      equations.add(distances.back().gradient, distances.back().value);
    }
    for (std::size_t i = 0; i < carriers.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (distances[i].gradient.cross(distances[j].gradient).norm() < touching_sine)
          add_contact(equations, carriers[i], carriers[j], point, size);
    const Eigen::Vector3d step = equations.least_step();
    point += step;
    if (step.norm() < 1e-15 * size) break;
  }
  return point;
}

}  // namespace isopatch::segmentation
