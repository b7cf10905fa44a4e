#include "segmentation/reconstruction/internal/fit_carrier.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/base/dense_matrices.hpp"
#include "segmentation/reconstruction/internal/carrier_distance.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::SurfaceKind;

// Steps of the least squares, and deviations over the size from which no other start is tried.
constexpr int most_steps = 60;
constexpr double near_enough = 1e-8;

// About so many points tell whether there is any carrier of a kind: twice a torus' parameters and some.
constexpr Eigen::Index few_points = 16;

using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;

/// Largest distance of points from a carrier.
double largest_distance(const Carrier& carrier, const Eigen::Matrix3Xd& points) {
  double result = 0;
  const CarrierDistances distances(carrier);
  for (const auto& p : points.colwise()) result = std::fmax(result, std::abs(distances.at(p).value));
  return result;
}

/// Which of the parameters a kind has: shift along two normals of the axis and along it, turn about the two,
/// radius, second.
std::array<bool, 7> all_parameters_of(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::plane:
      return {false, false, true, true, true, false, false};
    case SurfaceKind::sphere:
      return {true, true, true, false, false, true, false};
    case SurfaceKind::cylinder:
      return {true, true, false, true, true, true, false};
    case SurfaceKind::cone:
      return {true, true, false, true, true, true, true};
    default:
      return {true, true, true, true, true, true, true};
  }
}

std::array<bool, 7> parameters_of(SurfaceKind kind, const FitFreedom& free) {
  const std::array<bool, 7> may{free.shift, free.shift, true, free.turn, free.turn, free.radius, free.radius};
  std::array<bool, 7> result = all_parameters_of(kind);
  for (std::size_t i = 0; i < 7; ++i) result[i] = result[i] && may[i];
  return result;
}

/// Sums over points of (derivatives by the parameters, distance) with itself, (8, 8): a width that processors
/// take at once.
struct NormalEquations {
  Eigen::Matrix<double, 8, 8> sums = Eigen::Matrix<double, 8, 8>::Zero();

  Matrix7 matrix() const { return sums.topLeftCorner<7, 7>(); }
  Vector7 right() const { return -sums.col(7).head<7>(); }
  double squares() const { return sums(7, 7); }
};

NormalEquations equations(const Carrier& carrier, const Eigen::Matrix3Xd& points,
                          const std::array<bool, 7>& used) {
  const Eigen::Vector3d x = any_normal(carrier.axis), y = carrier.axis.cross(x);
  const CarrierDistances distances(carrier);
  Eigen::Matrix<double, 8, 1> kept = Eigen::Matrix<double, 8, 1>::Ones();
  for (std::size_t i = 0; i < 7; ++i) kept[static_cast<Eigen::Index>(i)] = used[i] ? 1 : 0;
  NormalEquations result;
  for (const auto& p : points.colwise()) {
    const CarrierDistance d = distances.at(p);
    const Eigen::Vector3d turn =
        d.gradient.cross(Eigen::Vector3d(p) - carrier.origin);  // by a turn of the axis
    Eigen::Matrix<double, 8, 1> row;
    row << -d.gradient.dot(x), -d.gradient.dot(y), -d.gradient.dot(carrier.axis), turn.dot(x), turn.dot(y),
        d.by_radius, d.by_second, d.value;
    row.array() *= kept.array();
    result.sums.noalias() += row * row.transpose();
  }
  return result;
}

Carrier moved(Carrier carrier, const Vector7& step) {
  const Eigen::Vector3d x = any_normal(carrier.axis), y = carrier.axis.cross(x);
  carrier.origin += step[0] * x + step[1] * y + step[2] * carrier.axis;
  const Eigen::Vector3d turn = step[3] * x + step[4] * y;
  if (turn.norm() > 0)
    carrier.axis = (Eigen::AngleAxisd(turn.norm(), turn.normalized()) * carrier.axis).normalized();
  carrier.radius += step[5];
  if (carrier.kind == SurfaceKind::cone)
    carrier.half_angle = Angle::radians(carrier.half_angle.radians() + step[6]);
  else
    carrier.second_radius += step[6];
  return carrier;
}

bool sensible(const Carrier& carrier) {
  if (!carrier.origin.allFinite() || !carrier.axis.allFinite()) return false;
  switch (carrier.kind) {
    case SurfaceKind::plane:
      return true;
    case SurfaceKind::cone: {
      const double angle = std::abs(carrier.half_angle.radians());
      return angle > 1e-3 && angle < 1.55;
    }
    case SurfaceKind::torus:
      // Also one that passes through itself, of which a crowned face is a part.
      return carrier.second_radius > 0 && carrier.radius > 0 && carrier.second_radius < 1e4;
    default:
      return carrier.radius > 0 && carrier.radius < 1e4;
  }
}

/// Points about their middle, of size one.
struct Standard {
  Eigen::Vector3d middle;
  double size;
  Eigen::Matrix3Xd points;

  explicit Standard(const Eigen::Matrix3Xd& given)
      : middle(given.rowwise().mean()), points(given.colwise() - middle) {
    size = std::sqrt(points.colwise().squaredNorm().maxCoeff());
    points /= size;
  }
  Carrier in(Carrier carrier) const {
    carrier.origin = (carrier.origin - middle) / size;
    carrier.radius /= size;
    carrier.second_radius /= size;
    return carrier;
  }
  Carrier out(Carrier carrier) const {
    carrier.origin = middle + size * carrier.origin;
    carrier.radius *= size;
    carrier.second_radius *= size;
    return carrier;
  }
};

/// The origin of a cylinder's or cone's axis moves to where the points are, so that turns and shifts are
/// apart.
Carrier near_points(Carrier carrier) {
  if (carrier.kind != SurfaceKind::cylinder && carrier.kind != SurfaceKind::cone &&
      carrier.kind != SurfaceKind::plane)
    return carrier;
  if (carrier.kind == SurfaceKind::plane) {
    carrier.origin = carrier.axis * carrier.axis.dot(carrier.origin);
    return carrier;
  }
  const double along = -carrier.axis.dot(carrier.origin);
  carrier.origin += along * carrier.axis;
  if (carrier.kind == SurfaceKind::cone) carrier.radius += along * std::tan(carrier.half_angle.radians());
  return carrier;
}

/// Whether a fit comes no nearer to its points, by its sums of squares from step to step.
class Stagnation {
 public:
  /// @param near  a sum of squares below which it is never said to stagnate
  Stagnation(double squares, double near) : history_{squares}, near_(near) {}

  /// Notes a step. @param squares  after it; nothing for a step that was taken back
  void step(std::optional<double> squares) {
    const double before = history_.back(), now = squares.value_or(before);
    slow_ = squares && now > slow_share * before ? slow_ + 1 : 0;
    history_.push_back(now);
  }
  bool is_hopeless() const {
    if (!(history_.back() > near_)) return false;
    return slow_ >= slow_steps || (history_.size() > window &&
                                   history_.back() > window_share * history_[history_.size() - 1 - window]);
  }

 private:
  // Three steps in sequence that lower distances by less than 3 %, or ten by less than 10 %. Of 300,000 fits
  // to patches of terrific.stl one in a hundred would have come to less than a third afterwards; all take 46
  // % of the steps.
  static constexpr int slow_steps = 3;
  static constexpr std::size_t window = 10;
  static constexpr double slow_share = 0.97 * 0.97, window_share = 0.9 * 0.9;

  std::vector<double> history_;
  double near_;
  int slow_ = 0;
};

/// Levenberg and Marquardt's method.
/// @param near  points farther than this are no use: given up where it comes no nearer; 0: to the end
std::optional<Carrier> least_squares(Carrier carrier, const Eigen::Matrix3Xd& points, const FitFreedom& free,
                                     double near) {
  const std::array<bool, 7> used = parameters_of(carrier.kind, free);
  const double count = double(points.cols());
  carrier = near_points(carrier);
  double damping = 1e-6;
  NormalEquations now = equations(carrier, points, used);
  Stagnation stagnation(now.squares(),
                        near > 0 ? near * near * count : std::numeric_limits<double>::infinity());
  for (int step = 0; step < most_steps; ++step) {
    Matrix7 matrix = now.matrix();
    for (Eigen::Index i = 0; i < 7; ++i) {
      matrix(i, i) += damping * matrix(i, i) + 1e-14 * count;
      if (!used[static_cast<std::size_t>(i)]) matrix(i, i) = 1;
    }
    const Vector7 change = solve_semidefinite(matrix, now.right());
    if (!change.allFinite()) return std::nullopt;
    Carrier next = moved(carrier, change);
    if (!sensible(next)) {
      damping = std::max(damping * 30, 1e-3);
      if (damping > 1e8) return std::nullopt;
      stagnation.step(std::nullopt);
      if (stagnation.is_hopeless()) return std::nullopt;
      continue;
    }
    next = near_points(next);
    const NormalEquations there = equations(next, points, used);
    if (!(there.squares() <= now.squares() * (1 + 1e-12) + 1e-30)) {
      damping = std::max(damping * 10, 1e-4);
      if (damping > 1e8) break;
      stagnation.step(std::nullopt);
      if (stagnation.is_hopeless()) return std::nullopt;
      continue;
    }
    const bool done = change.norm() < 1e-11 || there.squares() < 1e-28 * count;
    const bool slow = step > most_steps / 2 && now.squares() - there.squares() < 1e-3 * now.squares();
    carrier = next;
    now = there;
    damping = std::max(damping / 20, 1e-12);
    if (done || slow) break;
    stagnation.step(there.squares());
    if (stagnation.is_hopeless()) return std::nullopt;
  }
  if (!sensible(carrier)) return std::nullopt;
  return carrier;
}

std::optional<Carrier> plane_start(const SurfaceSample& s) {
  Carrier carrier{SurfaceKind::plane, s.points.rowwise().mean(), {}, 0, 0, {}};
  const Eigen::Matrix3Xd about = s.points.colwise() - carrier.origin;
  carrier.axis = principal_axes(about * about.transpose()).axes.col(0);
  return carrier;
}

/// The sphere, or seen along an axis the circle, of least algebraic error.
struct Round {
  Eigen::Vector3d center;
  double radius;
};

/// @param axis  of a circle; zero: a sphere
std::optional<Round> round_through(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& axis) {
  const bool flat = axis.squaredNorm() > 0;
  const Eigen::Vector3d middle = points.rowwise().mean();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const auto& p : points.colwise()) {
    const Eigen::Vector3d q = across * (Eigen::Vector3d(p) - middle);
    Eigen::Vector4d row;
    row << 2 * q, 1;
    matrix += row * row.transpose();
    right += row * q.squaredNorm();
  }
  if (flat) matrix.topLeftCorner<3, 3>() += axis * axis.transpose() * matrix.topLeftCorner<3, 3>().trace();
  const Eigen::Vector4d found = solve_semidefinite(matrix, right);
  const double square = found[3] + found.head<3>().squaredNorm();
  if (!found.allFinite() || !(square > 0)) return std::nullopt;
  return Round{middle + found.head<3>(), std::sqrt(square)};
}

std::optional<Carrier> sphere_start(const SurfaceSample& s) {
  const auto round = round_through(s.points, Eigen::Vector3d::Zero());
  if (!round) return std::nullopt;
  return Carrier{SurfaceKind::sphere, round->center, Eigen::Vector3d::UnitZ(), round->radius, 0, {}};
}

std::optional<Carrier> cylinder_start(const SurfaceSample& s) {
  const Eigen::Matrix3d sums = s.normals * s.normals.transpose();
  const Eigen::Vector3d axis = principal_axes(sums).axes.col(0);
  const auto round = round_through(s.points, axis);
  if (!round) return std::nullopt;
  return Carrier{SurfaceKind::cylinder, round->center, axis, round->radius, 0, {}};
}

/// A line that the normals of a surface of revolution meet.
struct Axis {
  Eigen::Vector3d foot, direction;
};

/// The line of a direction that normals meet best.
Axis axis_along(const Eigen::Vector3d& direction, const SurfaceSample& s) {
  Eigen::Matrix3d sums = direction * direction.transpose() * double(s.normals.cols());
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < s.normals.cols(); ++i) {
    const Eigen::Vector3d row = direction.cross(s.normals.col(i));
    sums += row * row.transpose();
    right -= row * direction.dot(s.middles.col(i).cross(s.normals.col(i)));
  }
  return {solve_semidefinite(sums, right), direction};
}

/// Points with the normals of a cubic through them, over the plane that the facets have in the mean: nearer
/// to the surface's own than those of facets are. Nothing for few points.
std::optional<SurfaceSample> with_smooth_normals(const SurfaceSample& s) {
  using Cubic = Eigen::Matrix<double, 10, 1>;
  if (s.points.cols() < 14) return std::nullopt;
  const Eigen::Vector3d z = s.normals.rowwise().sum().stableNormalized(), x = any_normal(z), y = z.cross(x);
  const Eigen::Vector3d middle = s.points.rowwise().mean();
  Eigen::Matrix<double, 10, 10> sums = Eigen::Matrix<double, 10, 10>::Zero();
  Cubic right = Cubic::Zero();
  Eigen::Matrix2Xd at(2, s.points.cols());
  for (Eigen::Index i = 0; i < s.points.cols(); ++i) {
    const Eigen::Vector3d way = s.points.col(i) - middle;
    const double a = x.dot(way), b = y.dot(way);
    at.col(i) << a, b;
    Cubic row;
    row << 1, a, b, a * a, a * b, b * b, a * a * a, a * a * b, a * b * b, b * b * b;
    sums += row * row.transpose();
    right += row * z.dot(way);
  }
  sums.diagonal().array() += 1e-12;
  const Cubic c = solve_semidefinite(sums, right);
  if (!c.allFinite()) return std::nullopt;
  SurfaceSample result{s.points, s.points, Eigen::Matrix3Xd(3, s.points.cols())};
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    const double a = at(0, i), b = at(1, i);
    const double by_a = c[1] + 2 * c[3] * a + c[4] * b + 3 * c[6] * a * a + 2 * c[7] * a * b + c[8] * b * b;
    const double by_b = c[2] + c[4] * a + 2 * c[5] * b + c[7] * a * a + 2 * c[8] * a * b + 3 * c[9] * b * b;
    result.normals.col(i) = (z - by_a * x - by_b * y).normalized();
  }
  return result;
}

/// Where the axis may be: Pluecker's coordinates of the normals are orthogonal to its own; normals lean
/// equally to it, or are at right angles to it.
std::vector<Axis> possible_axes(const SurfaceSample& s) {
  std::vector<Axis> result;
  Eigen::Matrix<double, 6, 6> sums = Eigen::Matrix<double, 6, 6>::Zero();
  for (Eigen::Index i = 0; i < s.normals.cols(); ++i) {
    Eigen::Matrix<double, 6, 1> row;
    row << s.middles.col(i).cross(s.normals.col(i)), s.normals.col(i);
    sums += row * row.transpose();
  }
  const Eigen::MatrixXd found = symmetric_eigen(sums).vectors;
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Eigen::Vector3d direction = found.col(k).head<3>();
    if (direction.norm() > 1e-6) result.push_back(axis_along(direction.normalized(), s));
  }
  const Eigen::Vector3d mean = s.normals.rowwise().mean();
  const Eigen::Matrix3Xd about = s.normals.colwise() - mean;
  const Eigen::Matrix3d leaning = principal_axes(about * about.transpose()).axes;
  for (Eigen::Index k = 0; k < 2; ++k) result.push_back(axis_along(leaning.col(k), s));
  result.push_back(axis_along(principal_axes(s.normals * s.normals.transpose()).axes.col(0), s));
  return result;
}

/// Distance from the axis and height of each point, (3, n) with zeros.
Eigen::Matrix3Xd profile_of(const Axis& axis, const Eigen::Matrix3Xd& points) {
  Eigen::Matrix3Xd result(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double height = axis.direction.dot(points.col(i) - axis.foot);
    result.col(i) << (points.col(i) - axis.foot - height * axis.direction).norm(), height, 0;
  }
  return result;
}

/// A cone about an axis: its profile is a line.
std::optional<Carrier> cone_about(const Axis& axis, const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd profile = profile_of(axis, points);
  const Eigen::Vector3d mean = profile.rowwise().mean();
  const Eigen::Matrix3Xd about = profile.colwise() - mean;
  const double squares = about.row(1).squaredNorm();
  if (!(squares > 0)) return std::nullopt;
  const double slope = about.row(0).dot(about.row(1)) / squares;
  return Carrier{SurfaceKind::cone,
                 axis.foot + mean.y() * axis.direction,
                 axis.direction,
                 mean.x(),
                 0,
                 Angle::radians(std::atan(slope))};
}

/// A torus about an axis: its profile is a circle.
std::optional<Carrier> torus_about(const Axis& axis, const Eigen::Matrix3Xd& points) {
  const auto round = round_through(profile_of(axis, points), Eigen::Vector3d::UnitZ());
  if (!round) return std::nullopt;
  return Carrier{SurfaceKind::torus, axis.foot + round->center.y() * axis.direction,
                 axis.direction,     round->center.x(),
                 round->radius,      {}};
}

std::optional<Carrier> best_about(const std::vector<Axis>& axes, SurfaceKind kind,
                                  const Eigen::Matrix3Xd& points) {
  std::optional<Carrier> best;
  double least = 0;
  for (const Axis& axis : axes) {
    const auto carrier = kind == SurfaceKind::cone ? cone_about(axis, points) : torus_about(axis, points);
    if (!carrier || !sensible(*carrier)) continue;
    const double off = largest_distance(*carrier, points);
    if (best && !(off < least)) continue;
    best = carrier;
    least = off;
  }
  return best;
}

/// Where to begin: of cones and tori by the facets' normals, and by those of a cubic.
std::vector<std::optional<Carrier>> starts_of(SurfaceKind kind, const SurfaceSample& sample) {
  switch (kind) {
    case SurfaceKind::plane:
      return {plane_start(sample)};
    case SurfaceKind::sphere:
      return {sphere_start(sample)};
    case SurfaceKind::cylinder:
      return {cylinder_start(sample)};
    default: {
      std::vector<std::optional<Carrier>> result{best_about(possible_axes(sample), kind, sample.points)};
      if (const auto smooth = with_smooth_normals(sample))
        result.push_back(best_about(possible_axes(*smooth), kind, sample.points));
      return result;
    }
  }
}

/// Some of many points, from all over them.
Eigen::Matrix3Xd few_of(const Eigen::Matrix3Xd& points) {
  const Eigen::Index step = points.cols() / few_points;
  if (step < 2) return points;
  Eigen::Matrix3Xd result(3, (points.cols() + step - 1) / step);
  for (Eigen::Index i = 0; i < result.cols(); ++i) result.col(i) = points.col(i * step);
  return result;
}

/// A start, moved to where it is nearest to a few points; nothing if those are farther from it in the mean
/// than all may be, and so from any carrier of its kind.
std::optional<Carrier> tried_on_few(const Standard& standard, const Eigen::Matrix3Xd& few,
                                    const std::optional<Carrier>& start, double near) {
  if (!start) return std::nullopt;
  const auto found = least_squares(*start, few, {}, near / standard.size);
  if (!found) return std::nullopt;
  const double squares = equations(*found, few, parameters_of(found->kind, {})).squares();
  const double allowed = near / standard.size;
  return squares <= allowed * allowed * double(few.cols()) ? found : std::nullopt;
}

std::optional<CarrierFit> finished(const Standard& standard, const std::optional<Carrier>& start,
                                   const Eigen::Matrix3Xd& points, const FitFreedom& free = {},
                                   double near = 0) {
  if (!start) return std::nullopt;
  const auto found = least_squares(*start, standard.points, free, near / standard.size);
  if (!found) return std::nullopt;
  Carrier carrier = standard.out(*found);
  if (carrier.kind == SurfaceKind::cone && carrier.half_angle.radians() < 0) {
    carrier.axis = -carrier.axis;
    carrier.half_angle = Angle::radians(-carrier.half_angle.radians());
  }
  return CarrierFit{carrier, largest_distance(carrier, points)};
}

}  // namespace

std::optional<CarrierFit> fit_carrier(SurfaceKind kind, const SurfaceSample& sample, double near) {
  if (sample.points.cols() < freedoms(kind)) return std::nullopt;
  const Standard standard(sample.points);
  const SurfaceSample scaled{standard.points, (sample.middles.colwise() - standard.middle) / standard.size,
                             sample.normals};
  std::optional<CarrierFit> best;
  const Eigen::Matrix3Xd few = few_of(standard.points);
  for (std::optional<Carrier> start : starts_of(kind, scaled)) {
    if (near > 0 && few.cols() < standard.points.cols()) start = tried_on_few(standard, few, start, near);
    const auto fit = finished(standard, start, sample.points, {}, near);
    if (fit && (!best || fit->largest < best->largest)) best = fit;
    if (best && best->largest < near_enough * standard.size) break;
  }
  return best;
}

std::optional<CarrierFit> fit_torus(const Carrier& about, const Eigen::Matrix3Xd& points) {
  const Standard standard(points);
  const Carrier scaled = standard.in(about);
  return finished(standard, best_about({{scaled.origin, scaled.axis}}, SurfaceKind::torus, standard.points),
                  points);
}

std::optional<CarrierFit> refit_carrier(const Carrier& start, const Eigen::Matrix3Xd& points,
                                        const FitFreedom& free) {
  if (points.cols() < freedoms(start.kind)) return std::nullopt;
  const Standard standard(points);
  return finished(standard, standard.in(start), points, free);
}

}  // namespace isopatch::segmentation
