#include "segmentation/turned/internal/half_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/base/angle.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/arc.hpp"
#include "segmentation/sweeps/piece_of_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::SurfaceKind;

class HalfProfileMaker {
 public:
  HalfProfileMaker(const Brep& solid, const TurnedFrame& frame) : solid_(solid), frame_(frame) {}

  HalfProfile make() {
    for (const FaceId face : frame_.faces) add_face(face);
    for (const FaceId face : frame_.prisms) add_prism_wall(face);
    return std::move(made_);
  }

 private:
  /// Whether an edge lies in a half-plane of the axis.
  bool is_meridian(EdgeId edge) const {
    for (const double t : {0.2, 0.45, 0.7}) {
      const Eigen::Vector3d point = solid_.point(edge, t);
      if (frame_.flat(point)[0] < tolerance_) continue;
      const Eigen::Vector3d around = frame_.along.cross(point - frame_.origin).normalized();
      if (std::abs(around.dot(solid_.tangent(edge, t).normalized())) > 1e-6) return false;
    }
    return std::cos(frame_.angle(solid_.point(edge, 0.2)) - frame_.angle(solid_.point(edge, 0.7))) > 0.5;
  }

  void add_face(FaceId face) {
    const auto carrier = solid_.carrier(face);
    if (carrier && carrier->kind == SurfaceKind::plane) return add_plane(face);
    if (carrier && carrier->kind == SurfaceKind::sphere) return add_sphere(face, *carrier);
    bool found = false;
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        if (is_meridian(use.edge)) {
          add_edge(use.edge, face);
          found = true;
        }
    if (!found)
      throw Error(ErrorCode::unsupported,
                  fmt::format("{} has no edge in a plane through the axis", describe(solid_, face)));
  }

  void add_plane(FaceId face) {
    double least = solid_.size(), largest = 0, height = 0;
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const bool is_corner = t == 0 || t == 1;
          if (!is_corner && solid_.edge(use.edge).kind == geometry::CurveKind::line) continue;
          const Eigen::Vector2d flat = frame_.flat(solid_.point(use.edge, t));
          least = std::min(least, flat[0]);
          largest = std::max(largest, flat[0]);
          height = flat[1];
        }
    if (reaches(face, height)) least = 0;
    HalfCurve curve;
    curve.start = vertex({least, height});
    curve.end = vertex({largest, height});
    curve.faces = {face};
    add(std::move(curve));
  }

  /// Its corners.
  void add_prism_wall(FaceId face) {
    double radius = 0, low = 1e300, high = -1e300;
    for (const geometry::EdgeUse& use : solid_.face(face).loops.front())
      for (const double t : {0.0, 1.0}) {
        const Eigen::Vector2d flat = frame_.flat(solid_.point(use.edge, t));
        radius = flat[0];
        low = std::min(low, flat[1]);
        high = std::max(high, flat[1]);
      }
    HalfCurve curve;
    curve.start = vertex({radius, low});
    curve.end = vertex({radius, high});
    curve.faces = {face};
    curve.of_prism = true;
    add(std::move(curve));
  }

  /// Whether a face has the point of the axis at a height.
  bool reaches(FaceId face, double height) const {
    const geometry::FaceProjection on = solid_.project(face, frame_.point({0, height}, 0));
    return on.distance < tolerance_ && solid_.contains(face, on.uv);
  }

  /// Adds the arc of a sphere, from the lowest to the highest angle of its edges, or to the poles that it
  /// has.
  void add_sphere(FaceId face, const geometry::Carrier& sphere) {
    const double height = frame_.flat(sphere.origin)[1], radius = sphere.radius;
    double from = std::numbers::pi, to = 0;
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const Eigen::Vector2d flat = frame_.flat(solid_.point(use.edge, t));
          const double angle = std::atan2(flat[0], flat[1] - height);
          from = std::min(from, angle);
          to = std::max(to, angle);
        }
    if (reaches(face, height + radius)) from = 0;
    if (reaches(face, height - radius)) to = std::numbers::pi;
    HalfCurve curve;
    curve.arc = PolarArc{height, radius, from, to};
    curve.start = vertex(curve.arc->point(0));
    curve.end = vertex(curve.arc->point(1));
    curve.faces = {face};
    add(std::move(curve));
  }

  void add_edge(EdgeId edge, FaceId face) {
    const bool closed = solid_.edge(edge).start == solid_.edge(edge).end;
    HalfCurve curve;
    curve.edge = edge;
    curve.angle = frame_.angle(solid_.point(edge, 0.45));
    curve.faces = {face};
    if (!closed) {
      curve.start = vertex(frame_.flat(solid_.point(edge, 0)));
      curve.end = vertex(frame_.flat(solid_.point(edge, 1)));
    }
    add(std::move(curve));
  }

  int vertex(const Eigen::Vector2d& place) {
    for (std::size_t v = 0; v < made_.vertices.size(); ++v)
      if ((made_.vertices[v] - place).norm() < tolerance_) return static_cast<int>(v);
    made_.vertices.push_back(place);
    return static_cast<int>(made_.vertices.size()) - 1;
  }

  /// Whether the middle of a curve is on another; closed ones may begin elsewhere.
  bool is_on(const HalfCurve& known, const HalfCurve& curve) const {
    const Eigen::Vector2d middle = point(solid_, frame_, made_, curve, 0.5);
    if (known.edge)
      return solid_.project(*known.edge, frame_.point(middle, known.angle)).distance < tolerance_;
    return (point(solid_, frame_, made_, known, 0.5) - middle).norm() < tolerance_;
  }

  void add(HalfCurve curve) {
    for (HalfCurve& known : made_.curves) {
      if (std::minmax(known.start, known.end) != std::minmax(curve.start, curve.end) || !is_on(known, curve))
        continue;
      if (std::find(known.faces.begin(), known.faces.end(), curve.faces.front()) == known.faces.end())
        known.faces.push_back(curve.faces.front());
      return;
    }
    made_.curves.push_back(std::move(curve));
  }

  const Brep& solid_;
  const TurnedFrame& frame_;
  double tolerance_ = 1e-7 * solid_.size();
  HalfProfile made_;
};

}  // namespace

Eigen::Vector2d PolarArc::point(double share) const {
  const double angle = from + share * (to - from);
  // Poles lie on the axis.
  const bool is_pole = angle <= 0 || angle >= std::numbers::pi;
  return {is_pole ? 0 : radius * std::sin(angle), height + radius * std::cos(angle)};
}

HalfProfile half_profile(const Brep& solid, const TurnedFrame& frame) {
  return HalfProfileMaker(solid, frame).make();
}

Eigen::Vector2d point(const Brep& solid, const TurnedFrame& frame, const HalfProfile& profile,
                      const HalfCurve& curve, double share) {
  const double t = curve.low + share * (curve.high - curve.low);
  if (curve.edge) return frame.flat(solid.point(*curve.edge, t));
  if (curve.arc) return curve.arc->point(t);
  return (1 - share) * profile.vertices[static_cast<std::size_t>(curve.start)] +
         share * profile.vertices[static_cast<std::size_t>(curve.end)];
}

bool is_straight(const Brep& solid, const HalfCurve& curve) {
  return curve.edge ? solid.edge(*curve.edge).kind == geometry::CurveKind::line : !curve.arc;
}

geometry::NurbsCurve piece_of_half_curve(const Brep& solid, const TurnedFrame& frame, const HalfCurve& curve,
                                         double low, double high) {
  const double from = curve.low + low * (curve.high - curve.low),
               to = curve.low + high * (curve.high - curve.low);
  if (curve.edge) return frame.turned(piece_of_curve(solid, *curve.edge, from, to), -curve.angle);
  const PolarArc& arc = *curve.arc;
  // About y, angles from the axis grow towards x.
  return geometry::arc_about(frame.point({0, arc.height}, 0), frame.y, frame.point(arc.point(from), 0),
                             Angle::radians((to - from) * (arc.to - arc.from)));
}

}  // namespace isopatch::segmentation
