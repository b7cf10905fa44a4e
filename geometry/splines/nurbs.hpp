#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/splines/knot_vector.hpp"

namespace isopatch::geometry {

/// A parameter of a D-dimensional spline.
template <int D>
using Parameter = Eigen::Matrix<double, D, 1>;

/// A NURBS curve (D = 1), surface (D = 2) or volume (D = 3) in space; a B-spline if all weights are equal.
///
/// Control points are stored with the first direction running fastest. Invariant: as many control points and
/// weights as basis functions, all finite, weights positive.
template <int D>
class Nurbs {
 public:
  bool operator==(const Nurbs&) const = default;

  static constexpr int dimension = D;
  using KnotVectors = std::array<KnotVector, D>;

  /// The unit segment, square or cube.
  Nurbs();

  /// A B-spline: all weights are 1.
  /// @param control_points  (3, n), model units
  /// @throws Error invalid_argument, naming the count, point or weight that breaks the invariant
  Nurbs(KnotVectors knots, Eigen::Matrix3Xd control_points);
  /// @param control_points  (3, n), model units, not multiplied by the weights
  /// @param weights         (n), positive
  Nurbs(KnotVectors knots, Eigen::Matrix3Xd control_points, Eigen::VectorXd weights);

  /// Inverse of `homogeneous()`.
  /// @param homogeneous  (4, n): control points times weights, then the weights
  static Nurbs from_homogeneous(KnotVectors knots, const Eigen::Matrix4Xd& homogeneous);

  const KnotVectors& knots() const { return knots_; }
  const KnotVector& knots(int direction) const { return knots_[static_cast<std::size_t>(direction)]; }
  int degree(int direction) const { return knots(direction).degree(); }
  /// Number of control points along a direction.
  int size(int direction) const { return knots(direction).size(); }
  std::array<int, D> sizes() const;
  /// Number of control points.
  int size() const { return static_cast<int>(control_points_.cols()); }
  const Eigen::Matrix3Xd& control_points() const { return control_points_; }
  const Eigen::VectorXd& weights() const { return weights_; }
  Eigen::Matrix4Xd homogeneous() const;
  /// Whether the weights differ.
  bool is_rational() const { return rational_; }

  /// The parameters at the low and at the high end of every direction.
  Parameter<D> low() const;
  Parameter<D> high() const;

  /// Point at a parameter, clamped into the domain. (3), model units.
  Eigen::Vector3d point(const Parameter<D>& parameter) const;

  /// First derivatives, one column per direction. (3, D), model units per parameter.
  Eigen::Matrix<double, 3, D> jacobian(const Parameter<D>& parameter) const;

  /// Mixed partial derivative; `order` says how often to differentiate along each direction.
  /// @source Piegl, Tiller, The NURBS Book, equation 4.20, for any number of directions
  Eigen::Vector3d derivative(const Parameter<D>& parameter, const std::array<int, D>& order) const;

 private:
  KnotVectors knots_;
  Eigen::Matrix3Xd control_points_;
  Eigen::VectorXd weights_;
  bool rational_ = false;
};

using NurbsCurve = Nurbs<1>;
using NurbsSurface = Nurbs<2>;
using NurbsVolume = Nurbs<3>;

extern template class Nurbs<1>;
extern template class Nurbs<2>;
extern template class Nurbs<3>;

}  // namespace isopatch::geometry
