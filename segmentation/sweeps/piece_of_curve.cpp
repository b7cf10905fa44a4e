#include "segmentation/sweeps/piece_of_curve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "geometry/base/angle.hpp"
#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::KnotVector;
using geometry::NurbsCurve;

double wrapped(double t) {
  return t > 1 ? t - 1 : t;
}

/// A conic by its ends, the tangents there and the point in the middle of its parameter range: circles and
/// their affine images, as kernels run through them.
NurbsCurve conic_piece(const Brep& brep, EdgeId edge, double low, double high) {
  const Eigen::Vector3d start = brep.point(edge, wrapped(low)), end = brep.point(edge, wrapped(high));
  const Eigen::Vector3d out = brep.tangent(edge, wrapped(low)).normalized();
  const Eigen::Vector3d in = brep.tangent(edge, wrapped(high)).normalized();
  const Eigen::Vector3d normal = out.cross(in);
  const double turn = std::atan2(normal.norm(), out.dot(in));
  constexpr double largest_turn = Angle::degrees(170).radians();
  if (turn > largest_turn)
    throw Error(ErrorCode::unsupported, fmt::format("an arc of {:.0f} degrees on edge {} has to be divided",
                                                    Angle::radians(turn).degrees(), edge.value));
  // Where the tangents meet.
  const double along = (end - start).cross(in).dot(normal) / normal.squaredNorm();
  const Eigen::Vector3d apex = start + along * out;
  const Eigen::Vector3d middle = (start + end) / 2;
  const Eigen::Vector3d shoulder = brep.point(edge, wrapped((low + high) / 2));
  const double weight = (shoulder - middle).norm() / (apex - shoulder).norm();
  Eigen::Matrix3Xd points(3, 3);
  points << start, apex, end;
  return NurbsCurve({KnotVector(2, {0, 0, 0, 1, 1, 1})}, points, Eigen::Vector3d(1, weight, 1));
}

/// One curve of two that meet, the first up to a parameter.
NurbsCurve joined(const NurbsCurve& first, const NurbsCurve& second, double at) {
  const auto degree = static_cast<std::ptrdiff_t>(first.degree(0));
  const KnotVector low = rescaled(first.knots(0), 0, at), high = rescaled(second.knots(0), at, 1);
  std::vector<double> knots(low.knots().begin(), low.knots().end() - 1);
  knots.insert(knots.end(), high.knots().begin() + degree + 1, high.knots().end());
  Eigen::Matrix4Xd points(4, first.size() + second.size() - 1);
  points << first.homogeneous(), second.homogeneous().rightCols(second.size() - 1);
  return NurbsCurve::from_homogeneous({KnotVector(static_cast<int>(degree), std::move(knots))}, points);
}

}  // namespace

/// With knots of full multiplicity at both ends of the piece, what lies between them.
NurbsCurve piece_of_curve(const NurbsCurve& whole, double low, double high) {
  const double first = whole.low()[0], length = whole.high()[0] - first;
  std::array<double, 2> ends = {first + low * length, first + high * length};
  for (double& end : ends)  // one that is a knot but for round-off
    for (const double knot : whole.knots(0).knots())
      if (std::abs(knot - end) < 1e-10 * length) end = knot;
  NurbsCurve curve = whole;
  const int degree = whole.degree(0);
  for (std::size_t i = 0; i < 2; ++i) {
    if (i == 0 ? low <= 0 : high >= 1) continue;
    const std::vector<double>& knots = curve.knots(0).knots();
    const auto known = std::count(knots.begin(), knots.end(), ends[i]);
    curve = insert_knots(
        curve, 0, std::vector<double>(static_cast<std::size_t>(std::max<long>(0, degree - known)), ends[i]));
  }
  const std::vector<double>& knots = curve.knots(0).knots();
  const auto begin = std::lower_bound(knots.begin(), knots.end(), ends[0]) - knots.begin();
  std::vector<double> inner;
  for (const double knot : knots)
    if (knot > ends[0] && knot < ends[1]) inner.push_back(knot);
  const Eigen::Index from = low <= 0 ? 0 : begin - 1;
  const Eigen::Index count = static_cast<Eigen::Index>(inner.size()) + degree + 1;
  std::vector<double> made(static_cast<std::size_t>(degree) + 1, 0.0);
  for (const double knot : inner) made.push_back((knot - ends[0]) / (ends[1] - ends[0]));
  made.insert(made.end(), static_cast<std::size_t>(degree) + 1, 1.0);
  return NurbsCurve({KnotVector(degree, made)}, curve.control_points().middleCols(from, count),
                    curve.weights().segment(from, count));
}

NurbsCurve piece_of_curve(const Brep& brep, EdgeId edge, double low, double high) {
  switch (brep.edge(edge).kind) {
    case geometry::CurveKind::line:
      return geometry::segment(brep.point(edge, low), brep.point(edge, high));
    case geometry::CurveKind::circle:
    case geometry::CurveKind::ellipse:
      return conic_piece(brep, edge, low, high);
    default:
      break;
  }
  const NurbsCurve whole = brep.curve(edge);
  return high > 1 ? joined(piece_of_curve(whole, low, 1), piece_of_curve(whole, 0, high - 1),
                           (1 - low) / (high - low))
                  : piece_of_curve(whole, low, high);
}

}  // namespace isopatch::segmentation
