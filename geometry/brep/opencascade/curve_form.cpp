#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <cmath>
#include <numbers>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/brep/opencascade/internal/carrier_forms.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"

namespace isopatch::geometry {
namespace {

constexpr int curve_samples = 33;

/// Points of a curve from end to end.
Eigen::Matrix3Xd points_along(const Geom_Curve& curve, double first, double last) {
  Eigen::Matrix3Xd result(3, curve_samples);
  for (int i = 0; i < curve_samples; ++i)
    result.col(i) = to_eigen(curve.Value(first + (last - first) * i / (curve_samples - 1)));
  return result;
}

gp_Dir direction(const Eigen::Vector3d& d) {
  return {d.x(), d.y(), d.z()};
}

std::optional<CurveForm> line_form(const Handle(Geom_Curve) & curve, const Eigen::Matrix3Xd& points,
                                   double tolerance) {
  const Eigen::Vector3d start = points.col(0), way = points.col(points.cols() - 1) - start;
  const double length = way.norm();
  if (!(length > 10 * tolerance)) return std::nullopt;
  const Eigen::Vector3d along = way / length;
  double before = 0;
  for (Eigen::Index i = 1; i < points.cols(); ++i) {
    const Eigen::Vector3d to = points.col(i) - start;
    const double at = along.dot(to);
    if (!((to - at * along).norm() <= tolerance) || !(at > before)) return std::nullopt;
    before = at;
  }
  return CurveForm{new Geom_Line(to_point(start), direction(along)), 0, length,
                   [=](double t) { return along.dot(to_eigen(curve->Value(t)) - start); }};
}

/// A conic in its plane: its centre and half axes as vectors, the longer one first.
struct Ellipse {
  Eigen::Vector3d center, major, minor;
};

/// The ellipse through points by least squares of its general equation.
std::optional<Ellipse> ellipse_through(const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d mean = points.rowwise().mean();
  const Eigen::Matrix3Xd about = points.colwise() - mean;
  const double size = about.colwise().norm().maxCoeff();
  const Eigen::Matrix3d sums = about * about.transpose() / (size * size);
  const Eigen::Matrix3d axes = principal_axes(sums).axes;
  const Eigen::Vector3d x = axes.col(2), y = axes.col(1);
  Eigen::Matrix<double, Eigen::Dynamic, 6> rows(points.cols(), 6);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double a = x.dot(about.col(i)) / size, b = y.dot(about.col(i)) / size;
    rows.row(i) << a * a, a * b, b * b, a, b, 1;
  }
  const Eigen::Matrix<double, 6, 1> q = left_singular(rows.transpose()).vectors.col(5);
  Eigen::Matrix2d form;
  form << q[0], q[1] / 2, q[1] / 2, q[2];
  if (!(form.determinant() > 0)) return std::nullopt;
  const Eigen::Vector2d center = -form.inverse() * q.segment<2>(3) / 2;
  const double level = center.dot(form * center) - q[5];
  const SymmetricEigen found = symmetric_eigen(form / level);
  const Eigen::Vector2d squares = found.values;
  if (!(squares.minCoeff() > 0)) return std::nullopt;
  const auto in_space = [&](const Eigen::Vector2d& p) -> Eigen::Vector3d {
    return size * (p.x() * x + p.y() * y);
  };
  return Ellipse{mean + in_space(center), in_space(found.vectors.col(0)) / std::sqrt(squares[0]),
                 in_space(found.vectors.col(1)) / std::sqrt(squares[1])};
}

/// The circle through three points, if it passes through all.
std::optional<Ellipse> circle_through_all(const Eigen::Matrix3Xd& points, double tolerance) {
  const Eigen::Index third = points.cols() / 3;
  const Eigen::Vector3d a = points.col(0), u = points.col(third) - a, v = points.col(2 * third) - a;
  const Eigen::Vector3d normal = u.cross(v);
  if (!(normal.norm() > 1e-9 * u.norm() * v.norm())) return std::nullopt;
  const Eigen::Vector3d center =
      a + (u.squaredNorm() * v - v.squaredNorm() * u).cross(normal) / (2 * normal.squaredNorm());
  const Eigen::Vector3d major = a - center, minor = normal.normalized().cross(major);
  for (const auto& p : points.colwise()) {
    const Eigen::Vector3d way = p - center;
    if (!(std::abs(way.norm() - major.norm()) <= tolerance) ||
        !(std::abs(normal.normalized().dot(way)) <= tolerance))
      return std::nullopt;
  }
  return Ellipse{center, major, minor};
}

std::optional<CurveForm> conic_form(const Handle(Geom_Curve) & curve, double first, double last,
                                    const Eigen::Matrix3Xd& points, double tolerance) {
  auto conic = circle_through_all(points, tolerance);
  const bool round = conic.has_value();
  if (!conic) conic = ellipse_through(points);
  if (!conic) return std::nullopt;
  const double a = conic->major.norm(), b = round ? a : conic->minor.norm();
  const Eigen::Vector3d center = conic->center;
  const Eigen::Vector3d x = conic->major / a;
  // The curve runs counter-clockwise about the normal.
  Eigen::Vector3d normal = conic->major.cross(conic->minor).normalized();
  if ((points.col(0) - center).cross(points.col(1) - center).dot(normal) < 0) normal = -normal;
  const Eigen::Vector3d y = normal.cross(x);
  const auto angle = [=](const Eigen::Vector3d& point) {
    return std::atan2(y.dot(point - center) / b, x.dot(point - center) / a);
  };
  const double start = angle(points.col(0));
  const auto after_start = [=](const Eigen::Vector3d& point) {
    const double way = angle(point) - start;
    return way < -1e-9 ? way + 2 * std::numbers::pi : way;
  };
  double before = 0;
  for (Eigen::Index i = 1; i < points.cols(); ++i) {
    double way = after_start(points.col(i));
    if (i + 1 == points.cols() && way < before) way += 2 * std::numbers::pi;  // all around
    const Eigen::Vector3d there = center + a * std::cos(start + way) * x + b * std::sin(start + way) * y;
    if (!((there - points.col(i)).norm() <= tolerance) || !(way > before)) return std::nullopt;
    before = way;
  }
  const gp_Ax2 frame(to_point(center), direction(normal), direction(x));
  Handle(Geom_Curve) made;
  if (round)
    made = new Geom_Circle(frame, a);
  else
    made = new Geom_Ellipse(frame, a, b);
  const double middle = (first + last) / 2, whole = before;
  return CurveForm{made, start, start + whole, [=](double t) {
                     double way = after_start(to_eigen(curve->Value(t)));
                     if (t > middle && way < whole / 4) way += 2 * std::numbers::pi;
                     return start + way;
                   }};
}

}  // namespace

std::optional<CurveForm> curve_form(const Handle(Geom_Curve) & curve, double first, double last,
                                    double tolerance) {
  const Eigen::Matrix3Xd points = points_along(*curve, first, last);
  if (auto line = line_form(curve, points, tolerance)) return line;
  return conic_form(curve, first, last, points, tolerance);
}

}  // namespace isopatch::geometry
