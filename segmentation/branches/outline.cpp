#include "segmentation/branches/internal/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "segmentation/sweeps/interpolate.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::SurfaceKind;

/// What a wall shows.
struct WallTrace {
  PlanCurve curve;
  Eigen::Vector2d place, outward;  // a point, and where the wall looks there
  std::vector<FaceId> walls;
};

/// Of angles, in [0, 2 pi).
double turn_between(double from, double to) {
  const double turn = to - from;
  return turn - 2 * std::numbers::pi * std::floor(turn / (2 * std::numbers::pi));
}

class Tracer {
 public:
  Tracer(const Brep& solid, const PlanView& view) : solid_(solid), view_(view) {}

  std::vector<Outline> make(const std::vector<FaceId>& walls) {
    for (const FaceId face : walls) add(face);
    std::vector<Outline> result;
    while (!traces_.empty()) result.push_back(next());
    return result;
  }

 private:
  /// Where edges along the view are, none twice.
  std::vector<Eigen::Vector2d> rulings(FaceId face) const {
    std::vector<Eigen::Vector2d> result;
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop) {
        if (!is_straight_along(solid_, use.edge, view_.along)) continue;
        const Eigen::Vector2d place = view_.flat(solid_.point(use.edge, 0.5));
        if (std::none_of(result.begin(), result.end(),
                         [&](const Eigen::Vector2d& known) { return is_same(known, place); }))
          result.push_back(place);
      }
    return result;
  }

  bool is_same(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
    return (a - b).norm() < 1e-6 * solid_.size();
  }

  [[noreturn]] void refuse(FaceId face, const std::string& what) const {
    throw Error(ErrorCode::unsupported, fmt::format("{} {}", describe(solid_, face), what));
  }

  /// A point of a face that is not on its edges.
  Eigen::Vector2d point_inside(FaceId face) const {
    const geometry::DomainBox box = solid_.domain(face);
    constexpr int steps = 9;
    for (int i = 0; i < steps * steps; ++i) {
      const int row = i / steps;
      const Eigen::Vector2d share((i % steps + 0.5) / steps, (row + 0.5) / steps);
      Eigen::Vector2d uv = box.low + share.cwiseProduct(box.high - box.low);
      if (solid_.contains(face, uv)) return uv;
    }
    refuse(face, "is too narrow to tell where it is");
  }

  void add(FaceId face) {
    const std::optional<geometry::Carrier> carrier = solid_.carrier(face);
    const std::vector<Eigen::Vector2d> ends = rulings(face);
    const Eigen::Vector2d uv = point_inside(face);
    WallTrace trace;
    trace.walls = {face};
    const Eigen::Vector3d normal = solid_.outward_normal(face, uv);
    trace.place = view_.flat(solid_.point(face, uv));
    trace.outward = {normal.dot(view_.x), normal.dot(view_.y)};
    const bool is_round = carrier && carrier->kind == SurfaceKind::cylinder;
    const bool is_plane = carrier && carrier->kind == SurfaceKind::plane;
    if (ends.size() > 2 || ends.size() < (is_plane ? 2U : is_round ? 0U : 1U))
      refuse(face, "is no wall between two edges along a branch");
    if (is_round)
      trace.curve = arc(view_.flat(carrier->origin), carrier->radius, ends, trace.place);
    else if (is_plane)
      trace.curve = {ends[0], ends[1]};
    else
      trace.curve = freeform(face, uv);
    for (WallTrace& known : traces_)
      if (is_one(known.curve, trace.curve)) {
        known.walls.push_back(face);
        return;
      }
    traces_.push_back(std::move(trace));
  }

  /// The first place, as a share, where a curve looks towards a corner of a square.
  static double first_turn(const auto& at) {
    const auto turn = [&](double share) {
      const Eigen::Vector3d way = at(share + 1e-4) - at(share);
      return std::sin(2 * std::atan2(way.y(), way.x()) - std::numbers::pi / 2);
    };
    constexpr int steps = 64;
    for (int i = 0; i + 1 < steps; ++i) {
      double low = static_cast<double>(i) / steps, high = static_cast<double>(i + 1) / steps;
      const bool rises = turn(low) < 0;
      if (rises == (turn(high) < 0)) continue;
      for (int k = 0; k < 30; ++k) ((turn((low + high) / 2) < 0) == rises ? low : high) = (low + high) / 2;
      return low;
    }
    return 0;
  }

  /// What a freeform wall shows, from one edge along the view to the other.
  PlanCurve freeform(FaceId face, const Eigen::Vector2d& inside) const {
    const auto derivatives = solid_.derivatives(face, inside);
    const auto lean = [&](Eigen::Index i) {
      return derivatives.col(i).normalized().cross(view_.along).norm();
    };
    const Eigen::Index across = lean(0) < lean(1) ? 1 : 0;
    if (lean(1 - across) > 1e-7) refuse(face, "is a wall whose parameters do not run along it");
    double low = 1e300, high = -1e300;
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        for (const double t : {0.0, 1.0}) {
          const double at = solid_.domain_point(face, use, t)[across];
          low = std::min(low, at);
          high = std::max(high, at);
        }
    const auto at = [&](double share) -> Eigen::Vector3d {
      Eigen::Vector2d uv = inside;
      uv[across] = low + share * (high - low);
      const Eigen::Vector2d place = view_.flat(solid_.point(face, uv));
      return {place.x(), place.y(), 0};
    };
    // What is closed begins where it looks towards a corner, as circles do.
    const double first = is_same(at(0).head<2>(), at(1).head<2>()) ? first_turn(at) : 0;
    const auto curve = [&](double share) {
      return at(first + share > 1 ? first + share - 1 : first + share);
    };
    PlanCurve result{curve(0).head<2>(), curve(1).head<2>()};
    result.spline = interpolated(curve, 1e-9 * solid_.size());
    return result;
  }

  PlanCurve arc(const Eigen::Vector2d& centre, double radius, const std::vector<Eigen::Vector2d>& ends,
                const Eigen::Vector2d& inside) const {
    if (ends.size() < 2) {
      // Divided at multiples of 90 degrees from where the middle of a side would be.
      const Eigen::Vector2d start = centre + radius * Eigen::Vector2d(std::sqrt(0.5), std::sqrt(0.5));
      return {start, start, centre, 2 * std::numbers::pi};
    }
    const auto angle = [&](const Eigen::Vector2d& point) {
      return std::atan2((point - centre).y(), (point - centre).x());
    };
    const double all = turn_between(angle(ends[0]), angle(ends[1]));
    const bool forwards = turn_between(angle(ends[0]), angle(inside)) < all;
    return {ends[0], ends[1], centre, forwards ? all : all - 2 * std::numbers::pi};
  }

  bool is_one(const PlanCurve& a, const PlanCurve& b) const {
    if (a.is_straight() != b.is_straight() || a.is_circle() != b.is_circle() ||
        a.spline.has_value() != b.spline.has_value())
      return false;
    if (a.is_circle())
      return is_same(a.centre, b.centre) &&
             std::abs((a.from - a.centre).norm() - (b.from - b.centre).norm()) < 1e-6 * solid_.size();
    return is_same(a.point(0.5), b.point(0.5)) && ((is_same(a.from, b.from) && is_same(a.to, b.to)) ||
                                                   (is_same(a.from, b.to) && is_same(a.to, b.from)));
  }

  /// The outline that the last wall is a part of.
  Outline next() {
    Outline result;
    WallTrace first = std::move(traces_.back());
    traces_.pop_back();
    result.curves = {first.curve};
    result.walls = first.walls;
    while (!first.curve.is_circle() && !is_same(result.curves.back().to, result.curves.front().from)) {
      const auto found = std::find_if(traces_.begin(), traces_.end(), [&](const WallTrace& other) {
        return is_same(other.curve.from, result.curves.back().to) ||
               is_same(other.curve.to, result.curves.back().to);
      });
      if (found == traces_.end())
        refuse(result.walls.back(), "is a wall of a branch that ends beside no other");
      const bool forwards = is_same(found->curve.from, result.curves.back().to);
      result.curves.push_back(forwards ? found->curve : found->curve.reversed());
      result.walls.insert(result.walls.end(), found->walls.begin(), found->walls.end());
      traces_.erase(found);
    }
    if (twice_area(result) < 0) {
      std::reverse(result.curves.begin(), result.curves.end());
      for (PlanCurve& curve : result.curves) curve = curve.reversed();
    }
    result.is_void = result.contains(first.place + 1e-3 * length(first.curve) * first.outward);
    return result;
  }

  /// About.
  static double length(const PlanCurve& curve) {
    constexpr int chords = 32;
    double sum = 0;
    for (int i = 0; i < chords; ++i)
      sum += (curve.point((i + 1.0) / chords) - curve.point(static_cast<double>(i) / chords)).norm();
    return sum;
  }

  static double twice_area(const Outline& outline) {
    double sum = 0;
    for (const PlanCurve& curve : outline.curves)
      for (int i = 0; i < 32; ++i) {
        const Eigen::Vector2d a = curve.point(i / 32.0), b = curve.point((i + 1) / 32.0);
        sum += a.x() * b.y() - a.y() * b.x();
      }
    return sum;
  }

  const Brep& solid_;
  const PlanView& view_;
  std::vector<WallTrace> traces_;
};

}  // namespace

bool Outline::contains(const Eigen::Vector2d& point) const {
  bool inside = false;
  constexpr int pieces = 256;
  for (const PlanCurve& curve : curves)
    for (int i = 0; i < pieces; ++i) {
      const Eigen::Vector2d a = curve.point(i / static_cast<double>(pieces)),
                            b = curve.point((i + 1) / static_cast<double>(pieces));
      if ((a.y() > point.y()) != (b.y() > point.y()) &&
          point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        inside = !inside;
    }
  return inside;
}

bool is_wall(const Brep& solid, FaceId face, const Eigen::Vector3d& along) {
  const auto carrier = solid.carrier(face);
  if (!carrier) return false;
  if (carrier->kind == SurfaceKind::plane) return std::abs(carrier->axis.dot(along)) < 1e-7;
  return carrier->kind == SurfaceKind::cylinder && carrier->axis.cross(along).norm() < 1e-7;
}

bool is_straight_along(const Brep& solid, EdgeId edge, const Eigen::Vector3d& along) {
  if (solid.edge(edge).kind != geometry::CurveKind::line &&
      solid.edge(edge).kind != geometry::CurveKind::spline)
    return false;
  constexpr std::array<double, 5> places = {0, 0.25, 0.5, 0.75, 1};
  return std::all_of(places.begin(), places.end(), [&](double t) {
    return solid.tangent(edge, t).normalized().cross(along).norm() < 1e-7;
  });
}

bool runs_along(const Brep& solid, FaceId face, const Eigen::Vector3d& along) {
  const geometry::DomainBox box = solid.domain(face);
  constexpr int steps = 9;
  for (int i = 0; i < steps * steps; ++i) {
    const int row = i / steps;
    const Eigen::Vector2d share((i % steps + 0.5) / steps, (row + 0.5) / steps);
    if (std::abs(solid.outward_normal(face, box.low + share.cwiseProduct(box.high - box.low)).dot(along)) >
        1e-7)
      return false;
  }
  return true;
}

std::vector<Outline> outlines_of(const Brep& solid, const PlanView& view, const std::vector<FaceId>& walls) {
  return Tracer(solid, view).make(walls);
}

}  // namespace isopatch::segmentation
