#include "iga/post/stress_measures.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/base/dense_matrices.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d sorted(Vector3d values) {
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

// The longest cross product of two columns of a singular matrix, of length 1: what it takes to zero.
Vector3d kernel_of(const Matrix3d& singular) {
  Vector3d longest = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3d product = Vector3d(singular.col(i)).cross(Vector3d(singular.col((i + 1) % 3)));
    if (product.squaredNorm() > longest.squaredNorm()) longest = product;
  }
  return longest.squaredNorm() > 0 ? longest.normalized() : Vector3d::UnitX();
}

}  // namespace

PrincipalStresses principal_stresses(const Eigen::Matrix3d& stress) {
  const PrincipalAxes found = principal_axes(stress);
  PrincipalStresses result{found.values.reverse(), found.axes.rowwise().reverse()};
  if (result.directions.determinant() < 0) result.directions.col(2) *= -1;
  return result;
}

// The value that is farther from the others than these from each other is a cosine, told to all digits; the
// others are those of what is left across its axis (Eberly, "A robust eigensolver for 3 x 3 symmetric
// matrices").
Eigen::Vector3d principal_values(const Eigen::Matrix3d& stress) {
  const double size = stress.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  if (!(size > 0) || !std::isfinite(size))
    return size == 0 ? Vector3d::Zero() : Vector3d::Constant(std::nan(""));
  if (stress(0, 1) == 0 && stress(0, 2) == 0 && stress(1, 2) == 0) return sorted(stress.diagonal());
  const Matrix3d scaled = stress / size;
  const double middle = scaled.trace() / 3;
  const Matrix3d deviator = scaled - middle * Matrix3d::Identity();
  const double spread = std::sqrt(deviator.squaredNorm() / 6);
  if (spread < 1e-20) return Vector3d::Constant(size * middle);
  const double cosine = std::clamp(0.5 * deviator.determinant() / (spread * spread * spread), -1.0, 1.0);
  const bool is_largest = cosine >= 0;
  const double alone =
      2 * spread * std::cos((std::acos(cosine) + (is_largest ? 0 : 2 * std::numbers::pi)) / 3);
  const Vector3d axis = kernel_of(deviator - alone * Matrix3d::Identity());
  const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const double uu = u.dot(deviator * u), uv = u.dot(deviator * v), vv = v.dot(deviator * v);
  const double between = 0.5 * (uu + vv), apart = 0.5 * (uu - vv);
  const double radius = std::sqrt(apart * apart + uv * uv);
  return size * (Vector3d::Constant(middle) + sorted({alone, between + radius, between - radius}));
}

double tresca(const Eigen::Matrix3d& stress) {
  const Eigen::Vector3d values = principal_values(stress);
  return values[0] - values[2];
}

double safety_factor(double von_mises, double yield) {
  return von_mises > 0 ? yield / von_mises : std::numeric_limits<double>::infinity();
}

}  // namespace isopatch::iga
