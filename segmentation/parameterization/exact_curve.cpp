#include "segmentation/parameterization/internal/exact_curve.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CurveKind;
using geometry::KnotVector;
using geometry::NurbsCurve;

/// Round-off of two evaluations, of the solid's size.
constexpr double same_point_of_edge = 1e-11;
/// Wider arcs have a knot: their weights and speeds would differ too much.
constexpr double widest_piece = 2 * std::numbers::pi / 3 + 1e-9;

/// Half the angle of an arc by the ratio of its chord to its speed in the middle, which is sin x / x.
double half_angle(double ratio) {
  double low = 0, high = std::numbers::pi;
  for (int i = 0; i < 60; ++i) {
    const double x = (low + high) / 2;
    (std::sin(x) > ratio * x ? low : high) = x;
  }
  return (low + high) / 2;
}

/// From the parameter of an arc of several equal pieces to its share of the angle.
double share_of_angle(double u, int pieces, double half_of_piece) {
  const double scaled = std::clamp(u, 0.0, 1.0) * pieces;
  const double piece = std::min(std::floor(scaled), pieces - 1.0);
  const double turned =
      std::atan((2 * (scaled - piece) - 1) * std::tan(half_of_piece / 2)) / (half_of_piece / 2);
  return (piece + (1 + turned) / 2) / pieces;
}

ExactCurve arc_of(const Brep& brep, EdgeId edge) {
  const Eigen::Vector3d chord = brep.point(edge, 1) - brep.point(edge, 0);
  // An edge's t goes with the angle; an ellipse is the image of a circle under an affine map.
  const double half = half_angle(chord.norm() / brep.tangent(edge, 0.5).norm());
  const int pieces = static_cast<int>(std::ceil(2 * half / widest_piece));
  const double half_of_piece = half / pieces, weight = std::cos(half_of_piece);
  Eigen::Matrix3Xd points(3, 2 * pieces + 1);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(2 * pieces + 1);
  points.col(0) = brep.point(edge, 0);
  for (int i = 0; i < pieces; ++i) {
    const Eigen::Vector3d shoulder = brep.point(edge, (i + 0.5) / pieces);
    points.col(2 * i + 2) = brep.point(edge, (i + 1.0) / pieces);
    const Eigen::Vector3d middle = (points.col(2 * i) + points.col(2 * i + 2)) / 2;
    points.col(2 * i + 1) = shoulder + (shoulder - middle) / weight;
    weights[2 * Eigen::Index(i) + 1] = weight;
  }
  return {NurbsCurve({KnotVector::uniform(2, pieces, 2)}, points, weights),
          [pieces, half_of_piece](double u) { return share_of_angle(u, pieces, half_of_piece); }};
}

/// The edge's own rational form; a single piece with the parameter that makes its end weights equal.
std::optional<ExactCurve> own_form(const Brep& brep, EdgeId edge) {
  const NurbsCurve own = brep.curve(edge);
  if (!own.is_rational()) return std::nullopt;
  const KnotVector knots = rescaled(own.knots(0), 0, 1);
  Eigen::VectorXd weights = own.weights() / own.weights()[0];
  const Eigen::Index last = weights.size() - 1;
  double factor = 1;
  if (std::abs(weights[last] - 1) > 1e-14) {
    if (knots.element_count() > 1) return std::nullopt;
    factor = std::pow(weights[last], -1 / double(last));
    for (Eigen::Index i = 0; i <= last; ++i) weights[i] *= std::pow(factor, double(i));
  }
  weights[last] = 1;
  return ExactCurve{NurbsCurve({knots}, own.control_points(), weights),
                    [factor](double u) { return factor * u / (factor * u + 1 - u); }};
}

bool agrees(const Brep& brep, EdgeId edge, const ExactCurve& exact) {
  for (const double u : {0.0, 0.13, 0.37, 0.5, 0.71, 0.93, 1.0})
    if (!((exact.curve.point(geometry::Parameter<1>(u)) - brep.point(edge, exact.pace(u))).norm() <=
          same_point_of_edge * brep.size()))
      return false;
  return true;
}

}  // namespace

std::optional<ExactCurve> exact_curve(const Brep& brep, EdgeId edge) {
  const CurveKind kind = brep.edge(edge).kind;
  if (kind == CurveKind::line || brep.edge(edge).start == brep.edge(edge).end) return std::nullopt;
  try {
    std::optional<ExactCurve> found =
        kind == CurveKind::circle || kind == CurveKind::ellipse ? arc_of(brep, edge) : own_form(brep, edge);
    if (found && agrees(brep, edge, *found)) return found;
  } catch (const Error&) {  // no rational form
  }
  return std::nullopt;
}

ExactCurve reversed(const ExactCurve& exact) {
  return {geometry::reversed(exact.curve, 0), [pace = exact.pace](double u) { return 1 - pace(1 - u); }};
}

}  // namespace isopatch::segmentation
