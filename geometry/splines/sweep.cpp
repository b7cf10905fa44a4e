#include "geometry/splines/sweep.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "geometry/base/error.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/transfer.hpp"

namespace isopatch::geometry {
namespace {

// The smallest space that contains both.
KnotVector common_space(const KnotVector& a, const KnotVector& b) {
  if (a.first() != b.first() || a.last() != b.last())
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("cannot blend a spline over [{}, {}] with one over [{}, {}]; rescale the knots of one",
                    a.first(), a.last(), b.first(), b.last()));
  const int degree = std::max(a.degree(), b.degree());
  const KnotVector raised_a = with_degree_raised(a, degree - a.degree());
  const KnotVector raised_b = with_degree_raised(b, degree - b.degree());
  std::vector<double> all;
  std::set_union(raised_a.knots().begin(), raised_a.knots().end(), raised_b.knots().begin(),
                 raised_b.knots().end(), std::back_inserter(all));
  return KnotVector(degree, std::move(all));
}

// Layers of control points, one after the other along a new direction.
template <int D>
Nurbs<D + 1> stacked(const typename Nurbs<D>::KnotVectors& knots, const KnotVector& last,
                     const std::vector<Eigen::Matrix3Xd>& points,
                     const std::vector<Eigen::VectorXd>& weights) {
  typename Nurbs<D + 1>::KnotVectors all;
  std::copy(knots.begin(), knots.end(), all.begin());
  all.back() = last;
  const Eigen::Index layer = points.front().cols();
  const auto layers = static_cast<Eigen::Index>(points.size());
  Eigen::Matrix3Xd stacked_points(3, layer * layers);
  Eigen::VectorXd stacked_weights(layer * layers);
  for (Eigen::Index i = 0; i < layers; ++i) {
    stacked_points.middleCols(i * layer, layer) = points[static_cast<std::size_t>(i)];
    stacked_weights.segment(i * layer, layer) = weights[static_cast<std::size_t>(i)];
  }
  return Nurbs<D + 1>(std::move(all), std::move(stacked_points), std::move(stacked_weights));
}

template <int D>
Nurbs<D + 1> blend(const Nurbs<D>& from, const Nurbs<D>& to) {
  typename Nurbs<D>::KnotVectors common;
  for (std::size_t d = 0; d < D; ++d) common[d] = common_space(from.knots()[d], to.knots()[d]);
  const Nurbs<D> low = refined(from, common);
  const Nurbs<D> high = refined(to, common);
  return stacked<D>(common, KnotVector::bezier(1), {low.control_points(), high.control_points()},
                    {low.weights(), high.weights()});
}

template <int D>
Nurbs<D + 1> moved_along(const Nurbs<D>& spline, const Eigen::Vector3d& vector) {
  if (!(vector.norm() > 0))
    throw Error(ErrorCode::invalid_argument, "an extrusion along a vector of no length");
  const Eigen::Matrix3Xd moved = spline.control_points().colwise() + vector;
  return stacked<D>(spline.knots(), KnotVector::bezier(1), {spline.control_points(), moved},
                    {spline.weights(), spline.weights()});
}

}  // namespace

NurbsSurface ruled(const NurbsCurve& from, const NurbsCurve& to) {
  return blend(from, to);
}
NurbsVolume ruled(const NurbsSurface& from, const NurbsSurface& to) {
  return blend(from, to);
}

NurbsSurface extruded(const NurbsCurve& curve, const Eigen::Vector3d& vector) {
  return moved_along(curve, vector);
}
NurbsVolume extruded(const NurbsSurface& surface, const Eigen::Vector3d& vector) {
  return moved_along(surface, vector);
}

NurbsVolume revolved(const NurbsSurface& surface, const Eigen::Vector3d& center, const Eigen::Vector3d& axis,
                     Angle sweep) {
  const double angle = sweep.radians();
  if (!(std::abs(angle) > 0 && std::abs(angle) < std::numbers::pi))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format(
            "a revolution by {:g} degrees: one piece takes more than 0 and less than 180; join several",
            sweep.degrees()));
  if (!(axis.norm() > 0)) throw Error(ErrorCode::invalid_argument, "a revolution about an axis of no length");
  const Eigen::Vector3d direction = axis.normalized();
  Eigen::Matrix3Xd middle = surface.control_points();
  Eigen::Matrix3Xd last = surface.control_points();
  for (Eigen::Index i = 0; i < last.cols(); ++i) {
    const Eigen::Vector3d start = surface.control_points().col(i);
    const Eigen::Vector3d foot = center + direction * direction.dot(start - center);
    const Eigen::Vector3d x = start - foot;
    const Eigen::Vector3d y = direction.cross(x);
    middle.col(i) = start + std::tan(0.5 * angle) * y;
    last.col(i) = foot + std::cos(angle) * x + std::sin(angle) * y;
  }
  return stacked<2>(surface.knots(), KnotVector::bezier(2), {surface.control_points(), middle, last},
                    {surface.weights(), std::cos(0.5 * angle) * surface.weights(), surface.weights()});
}

}  // namespace isopatch::geometry
