#include "segmentation/decomposition/cutting/spline_curve.hpp"

#include <algorithm>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/splines/grid.hpp"

namespace isopatch::segmentation {

using geometry::KnotVector;
using geometry::NurbsCurve;

NurbsCurve interpolated(const CurvePoints& curve, const KnotVector& knots) {
  const std::vector<double> at = knots.greville();
  Eigen::MatrixX3d points(static_cast<Eigen::Index>(at.size()), 3);
  for (std::size_t i = 0; i < at.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = curve(at[i]).transpose();
  const Eigen::MatrixXd matrix = geometry::collocation(knots, at);
  Eigen::Matrix3Xd control = solve_by_lu(matrix, points).transpose();
  control.col(0) = points.row(0).transpose();
  control.col(control.cols() - 1) = points.row(points.rows() - 1).transpose();
  return NurbsCurve({knots}, std::move(control));
}

double deviation(const CurvePoints& curve, const NurbsCurve& spline) {
  const int samples = 4 * spline.knots(0).element_count() * spline.degree(0) + 1;
  double worst = 0;
  for (int i = 1; i < samples; ++i) {
    const double t = double(i) / samples;
    worst = std::max(worst, (curve(t) - spline.point(geometry::Parameter<1>(t))).norm());
  }
  return worst;
}

KnotVector following_knots(const std::vector<CurvePoints>& curves, double tolerance) {
  const auto follow = [&](const KnotVector& knots) {
    return std::all_of(curves.begin(), curves.end(), [&](const CurvePoints& curve) {
      return deviation(curve, interpolated(curve, knots)) <= tolerance;
    });
  };
  if (KnotVector line = KnotVector::bezier(1); follow(line)) return line;
  int spans = 1;
  while (spans < 64 && !follow(KnotVector::uniform(5, spans))) spans *= 2;
  return KnotVector::uniform(5, spans);
}

}  // namespace isopatch::segmentation
