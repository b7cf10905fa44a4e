#include "segmentation/turned/internal/core_strips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// Of the angle at which a sphere ends or turns away: 54.7 degrees, the corner of a cube, of a right angle.
constexpr double corner_share = 0.608;
/// Of the radius of that corner: the column's side in a ball.
constexpr double inner_share = 0.55;
/// rad; spheres that turn less are divided like planes.
constexpr double far_turn = 1.0;

/// A curve that ends on the axis.
struct End {
  std::size_t curve;
  bool at_start;  // whether the curve starts there
  double height;
  std::optional<Spheroid> sphere;
  double radius = 0;    // at which it ends, turns back or meets the other end
  double corner = 0;    // radius of the column's corner; 0 where that is to be the column's
  bool bulges = false;  // with the solid inside the sphere
};

class CoreMaker {
 public:
  CoreMaker(const Brep& solid, const TurnedFrame& frame, HalfProfile profile, double share)
      : solid_(solid), frame_(frame), share_(share), made_{std::move(profile), {}} {}

  CoredProfile make() {
    std::vector<End> ends;
    for (std::size_t c = 0; c < outside().curves.size(); ++c) {
      const HalfCurve& curve = outside().curves[c];
      for (const bool at_start : {true, false}) {
        const int vertex = at_start ? curve.start : curve.end;
        if (vertex < 0 || place(vertex)[0] > tolerance_) continue;
        ends.push_back({c, at_start, place(vertex)[1], {}});
      }
    }
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.height < b.height; });
    if (ends.size() % 2 != 0) throw Error(ErrorCode::unsupported, "its half profile is open on the axis");
    for (std::size_t i = 0; i < ends.size(); ++i) look_at(ends[i], i % 2 == 0);
    // All radii are taken before the first curve is cut.
    std::vector<double> radii;
    for (std::size_t i = 0; i < ends.size(); i += 2) radii.push_back(core_radius(ends[i], ends[i + 1]));
    for (std::size_t i = 0; i < ends.size(); i += 2) add_strip(ends[i], ends[i + 1], radii[i / 2]);
    return std::move(made_);
  }

 private:
  HalfProfile& outside() { return made_.outside; }
  const HalfCurve& curve_of(const End& end) { return outside().curves[end.curve]; }
  Eigen::Vector2d place(int vertex) { return outside().vertices[static_cast<std::size_t>(vertex)]; }

  /// @param share  0 on the axis
  Eigen::Vector2d at(const End& end, double share) {
    return point(solid_, frame_, outside(), curve_of(end), end.at_start ? share : 1 - share);
  }

  [[noreturn]] void refuse(const End& end, const std::string& what) {
    const HalfCurve& curve = curve_of(end);
    throw Error(ErrorCode::unsupported,
                fmt::format("{} {} on the axis", describe(solid_, curve.faces.front()), what));
  }

  /// @param low  whether the solid is above it
  void look_at(End& end, bool low) {
    const Eigen::Vector2d last = at(end, 1), middle = at(end, 0.5);
    end.radius = std::max(last[0], middle[0]);
    if (is_straight(solid_, curve_of(end))) {
      if (std::abs(last[1] - end.height) > tolerance_) refuse(end, "comes to a point");
      return;
    }
    end.sphere = spheroid_of(end);
    if (!end.sphere) refuse(end, "is neither plane nor ellipsoid");
    const double centre = height_of_centre(end), radius = end.sphere->radius;
    end.bulges = (centre > end.height) == low;
    double turn = std::numbers::pi;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      const Eigen::Vector2d way = at(end, share) - Eigen::Vector2d(0, centre);
      end.radius = std::max(end.radius, way[0]);
      turn = std::atan2(way[0], way[1] / end.sphere->stretch * (end.height > centre ? 1 : -1));
    }
    turn = std::min(turn, std::numbers::pi / 2);
    end.radius = std::max(end.radius, radius * std::sin(turn));
    if (turn > far_turn) end.corner = radius * std::sin(corner_share * turn);
  }

  double height_of_centre(const End& end) const { return frame_.flat(end.sphere->centre)[1]; }

  /// The sphere that a curve shows, else the ellipsoid.
  std::optional<Spheroid> spheroid_of(const End& end) {
    const auto way = [&](double share) -> Eigen::Vector2d {
      return at(end, share) - Eigen::Vector2d(0, end.height);
    };
    const Eigen::Vector2d a = way(0.45), b = way(0.9);
    if (std::abs(a[1]) < tolerance_ || std::abs(b[1]) < tolerance_) return std::nullopt;
    // r^2 + k h^2 = 2 k c h, h from the pole, the centre at c.
    const double of_sphere = b.squaredNorm() / (2 * b[1]);
    if (auto sphere = spheroid(end, of_sphere, 1)) return sphere;
    const double slope_a = a[0] * a[0] / a[1], slope_b = b[0] * b[0] / b[1];
    const double k = (slope_a - slope_b) / (b[1] - a[1]);
    if (!(k > 0.01 && k < 100)) return std::nullopt;
    return spheroid(end, (slope_a + k * a[1]) / (2 * k), 1 / std::sqrt(k));
  }

  /// @param to_centre  from the pole, upwards
  /// @return  nothing if the curve is not on it
  std::optional<Spheroid> spheroid(const End& end, double to_centre, double stretch) {
    const Eigen::Vector2d centre(0, end.height + to_centre);
    const double radius = std::abs(to_centre) / stretch;
    for (const double share : {0.15, 0.3, 0.55, 0.7, 0.85, 1.0}) {
      const Eigen::Vector2d way = at(end, share) - centre;
      if (!(std::abs(std::hypot(way[0], way[1] / stretch) - radius) < tolerance_)) return std::nullopt;
    }
    return Spheroid{frame_.point(centre, 0), radius, frame_.along, stretch};
  }

  double core_radius(const End& low, const End& high) {
    double result = share_ * std::min(low.radius, high.radius);
    for (std::size_t c = 0; c < outside().curves.size(); ++c) {
      if (c == low.curve || c == high.curve) continue;
      for (int i = 0; i <= 16; ++i) {
        const Eigen::Vector2d beside = point(solid_, frame_, outside(), outside().curves[c], i / 16.0);
        if (beside[1] > low.height - tolerance_ && beside[1] < high.height + tolerance_ &&
            beside[0] > tolerance_)
          result = std::min(result, share_ * beside[0]);
      }
    }
    for (const End& end : {low, high})
      if (end.corner > 0) result = std::min(result, inner_share * end.corner);
    return result;
  }

  /// Takes off the part of the curve within a radius.
  /// @return  the vertex there
  int cut(const End& end, double radius) {
    double low = 0, high = 1;
    // Up to where it turns back, the radius grows.
    constexpr int steps = 64;
    for (int i = steps; i > 0; --i)
      if (const double share = static_cast<double>(i) / steps; at(end, share)[0] >= radius) high = share;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (at(end, middle)[0] < radius ? low : high) = middle;
    }
    const Eigen::Vector2d corner = at(end, high);
    const int made = vertex(corner);
    HalfCurve& curve = outside().curves[end.curve];
    const double share = end.at_start ? high : 1 - high;
    const double t = curve.low + share * (curve.high - curve.low);
    (end.at_start ? curve.start : curve.end) = made;
    (end.at_start ? curve.low : curve.high) = t;
    return made;
  }

  CoreEnd core_end(const End& end, double radius) {
    CoreEnd result;
    result.height = end.height;
    result.faces = curve_of(end).faces;
    result.sphere = end.sphere;
    result.vertex = cut(end, end.corner > 0 ? end.corner : radius);
    return result;
  }

  void add_strip(const End& low, const End& high, double radius) {
    CoreStrip strip;
    strip.low = core_end(low, radius);
    strip.high = core_end(high, radius);
    std::vector<int> corners = {strip.low.vertex};
    for (const auto& [end, made] : {std::pair(&low, &strip.low), std::pair(&high, &strip.high)})
      if (const auto corner = inner_corner(*end, *made, radius))
        if (corner->y() > place(strip.low.vertex).y() && corner->y() < place(strip.high.vertex).y())
          corners.push_back(vertex(*corner));
    corners.push_back(strip.high.vertex);
    for (std::size_t i = 1; i < corners.size(); ++i) {
      if (!(place(corners[i])[1] > place(corners[i - 1])[1] + tolerance_))
        throw Error(ErrorCode::unsupported, "its ends on the axis are too near to each other");
      strip.line.push_back(static_cast<int>(outside().curves.size()));
      HalfCurve side;
      side.start = corners[i - 1];
      side.end = corners[i];
      outside().curves.push_back(std::move(side));
    }
    made_.strips.push_back(std::move(strip));
  }

  /// Below the corner on a sphere that turns far, on the way to its centre.
  std::optional<Eigen::Vector2d> inner_corner(const End& end, const CoreEnd& made, double radius) {
    if (end.corner <= 0 || !end.bulges) return std::nullopt;
    const Eigen::Vector2d centre(0, height_of_centre(end)), corner = place(made.vertex);
    return centre + radius / corner[0] * (corner - centre);
  }

  int vertex(const Eigen::Vector2d& at) {
    outside().vertices.push_back(at);
    return static_cast<int>(outside().vertices.size()) - 1;
  }

  const Brep& solid_;
  const TurnedFrame& frame_;
  double share_;
  double tolerance_ = 1e-7 * solid_.size();
  CoredProfile made_;
};

}  // namespace

CoredProfile without_cores(const Brep& solid, const TurnedFrame& frame, HalfProfile profile, double share) {
  return CoreMaker(solid, frame, std::move(profile), share).make();
}

}  // namespace isopatch::segmentation
