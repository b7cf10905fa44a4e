#pragma once

namespace isopatch {

/// Geometric tolerances, all relative, so that a model in metres and one in millimetres behave alike.
struct Tolerance {
  /// Points closer than this times the diagonal of the model's box are the same point.
  /// Range (0, 1e-2). 1e-6 is 30 times the worst disagreement seen in a published model.
  double same_point = 1e-6;
  /// Faces that agree no better than `same_point` but better than this are reported as a gap, not as
  /// two boundary faces. Range (same_point, 0.1).
  double near_miss = 1e-3;
  /// Knots of two neighbours closer than this times the knot range are one knot. Range (0, 1e-3).
  double same_knot = 1e-9;
  /// Whether faces that lie on one another without agreeing point by point stay in the model, as
  /// non-matching interfaces; they are refused otherwise.
  bool keep_non_matching = false;
  bool operator==(const Tolerance&) const = default;
};

}  // namespace isopatch
