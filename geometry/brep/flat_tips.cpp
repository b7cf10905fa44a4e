#include "geometry/brep/flat_tips.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "geometry/base/error.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::geometry {
namespace {

/// The tip that a cone is, if it is one.
std::optional<DrillTip> tip_of(const Brep& solid, FaceId face) {
  const std::optional<Carrier> cone = solid.carrier(face);
  if (!cone || cone->kind != SurfaceKind::cone || solid.face(face).loops.size() != 1) return std::nullopt;
  const double slope = std::tan(cone->half_angle.radians()), close = 1e-6 * solid.size();
  DrillTip tip{face, cone->origin - cone->radius / slope * cone->axis, cone->axis, 0, 0};
  // Its rim is a circle; seams run up to the apex.
  bool has_apex = false;
  for (const EdgeUse& use : solid.face(face).loops.front()) {
    for (const double t : {0.0, 0.5, 1.0}) {
      const Eigen::Vector3d way = solid.point(use.edge, t) - tip.apex;
      has_apex = has_apex || way.norm() < close;
      if (solid.edge(use.edge).kind == CurveKind::line) continue;
      const double height = std::abs(way.dot(tip.axis));
      if (tip.depth > 0 && std::abs(height - tip.depth) > close) return std::nullopt;
      tip.depth = height;
      tip.radius = way.cross(tip.axis).norm();
      if (way.dot(tip.axis) < 0) tip.axis = -tip.axis;
    }
  }
  if (!has_apex || !(tip.depth > close) || !(tip.radius > close)) return std::nullopt;
  // What is left of the cone's middle looks at the axis.
  const Eigen::Vector3d side = tip.axis.unitOrthogonal();
  const FaceProjection middle =
      solid.project(face, tip.apex + 0.6 * (tip.depth * tip.axis + tip.radius * side));
  if (solid.outward_normal(face, middle.uv).dot(tip.axis) < 0) return std::nullopt;
  return tip;
}

}  // namespace

std::vector<DrillTip> drill_tips(const Brep& solid) {
  std::vector<DrillTip> result;
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f)
    if (const std::optional<DrillTip> tip = tip_of(solid, FaceId(f))) result.push_back(*tip);
  return result;
}

Brep with_flat_tips(const Brep& solid, const std::vector<DrillTip>& tips, double share) {
  if (!(share > 0 && share < 1))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("a flat of {} of a tip's radius is asked for; it must be between 0 and 1", share));
  if (tips.empty()) return solid;
  Brep result(brep_module().with_flat_tips(solid.kernel(), tips, share).kernel);
  if (result.faces().size() != solid.faces().size() + tips.size())
    throw Error(ErrorCode::unsupported,
                fmt::format("the tip of {} cannot be made flat", describe(solid, tips.front().cone)));
  require_solid(result);
  return result;
}

}  // namespace isopatch::geometry
