#pragma once

#include <array>

#include "geometry/jacobian_expansion.hpp"

namespace isopatch::geometry {

/// A box of a patch's parameters with det J on it, bounded by Bernstein coefficients.
struct JacobianPiece {
  BernsteinPolynomial
      numerator;             ///< of det J times weight^4 over `scale`, on the box scaled to the unit cube
  double error = 0;          ///< bound of a coefficient's round-off
  double halving_error = 0;  ///< what one more halving adds to it
  double scale = 1;
  double lowest_weight = 1;
  double highest_weight = 1;
  Parameter<3> low;
  Parameter<3> high;
  int depth = 0;  ///< halvings since the knot element

  /// Rigorous bounds of det J on the box, model units^3 per parameter^3.
  double lower() const;
  double upper() const;

  /// Corner with the smallest numerator; bit d of the index is set for the high end of direction d.
  int lowest_corner() const;
  double corner_numerator(int corner) const;
  Parameter<3> corner_parameter(int corner) const;

  /// The two halves along the direction that sharpens the bounds most.
  std::array<JacobianPiece, 2> halved() const;
};

/// The volume moved to the origin and scaled into the cube of half width 1, its largest weight 1.
struct CentredVolume {
  NurbsVolume volume;
  double radius = 1;  ///< what it was divided by, model units
};
CentredVolume centred(const NurbsVolume& volume);

/// @param element  a Bezier piece of a centred volume
/// @param radius   of the centred volume
JacobianPiece jacobian_piece(const NurbsVolume& element, double radius);

}  // namespace isopatch::geometry
