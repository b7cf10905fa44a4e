#pragma once

#include <vector>

#include "geometry/determinant_bounds.hpp"
#include "geometry/jacobian_piece.hpp"

namespace isopatch::geometry {

/// Rigorous bounds of det J on every knot element of a centred volume, elements of the first direction
/// running fastest; model units^3 per parameter^3.
///
/// Cheap: from boxes around the derivatives' control points, which hold for every Bernstein coefficient too.
/// Of a smooth patch they are as wide as its derivatives vary over degree + 1 elements.
/// @cost  some hundred operations an element, degree^2 sums over whole layers of control points
std::vector<Bounds> element_bounds(const CentredVolume& volume);

/// Sharper bounds of det J on one element, from the hull of its own derivatives' Bernstein coefficients.
/// @param element  a Bezier piece of a centred volume
Bounds element_bounds(const NurbsVolume& element, double radius);

/// The Bezier pieces of a volume one by one; the same as `bezier_pieces`, but only those that are asked for.
class BezierElements {
 public:
  explicit BezierElements(const NurbsVolume& volume);
  int count() const { return elements_[0] * elements_[1] * elements_[2]; }
  /// @param index  elements of the first direction running fastest
  NurbsVolume operator[](int index) const;

 private:
  /// An element along one direction.
  struct Piece {
    double low = 0, high = 0;
    int first = 0;               ///< of the control points that reach it
    Eigen::MatrixXd extraction;  ///< from those to its Bezier control points
  };
  const NurbsVolume& volume_;
  std::array<int, 3> elements_{};
  std::array<std::vector<Piece>, 3> pieces_;
};

}  // namespace isopatch::geometry
