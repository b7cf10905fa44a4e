#pragma once

#include "geometry/base/progress.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// A certificate of the sign of det J on a whole patch.
enum class JacobianSign {
  positive,     ///< det J > 0 everywhere
  nonnegative,  ///< det J >= 0, zero only where an edge or face is collapsed
  negative,     ///< det J < 0 at `parameter`
  undecided,    ///< the subdivision's limit was reached between the bounds; treat as not certified
};

struct JacobianCertificate {
  JacobianSign sign = JacobianSign::undecided;
  double lower = 0;        ///< rigorous lower bound of det J over the patch, model units^3 per parameter^3
  double upper = 0;        ///< rigorous upper bound
  Parameter<3> parameter;  ///< where the smallest value was evaluated
  Eigen::Vector3d place;   ///< the point there, model units
  double smallest = 0;     ///< det J there
  bool accepted() const { return sign == JacobianSign::positive || sign == JacobianSign::nonnegative; }
};

struct CertificateOptions {
  /// Halvings of an element before giving up, counted per direction: a piece is halved at most three times as
  /// often, each time along the direction that sharpens its bounds most. Range 0 .. 30.
  int max_depth = 12;
};

/// Certifies the sign of the Jacobian determinant of a volume map.
///
/// The bound is rigorous, round-off included: det J times the fourth power of the weight function (for
/// B-splines, det J itself) is expanded in Bernstein form on every knot element and subdivided until its sign
/// is clear. Elements whose derivatives' control points alone make its sign clear, and that can hold neither
/// the lowest nor the highest coefficient, are not expanded; the result is the same to 1e-9. Where very many
/// elements might hold them, as in fine patches that are the same all over, only 2,000 are expanded for each
/// end: `lower` and `upper` are then rigorous all the same, but wider by what an element's derivatives vary.
///
/// @param volume    any degree, control points (3, n), model units
/// @param progress  hears of the share of the elements
/// @cost            some hundred operations an element; O((3 p)^6) for each that is expanded, (4 p)^6 if
/// rational
/// @source          Johnen, Remacle, Geuzaine 2013, section 3
JacobianCertificate certify_jacobian(const NurbsVolume& volume, const CertificateOptions& options = {},
                                     const Progress& progress = {});

}  // namespace isopatch::geometry
