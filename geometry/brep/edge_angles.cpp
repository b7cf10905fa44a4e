#include "geometry/brep/edge_angles.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

/// A face that uses the edge, and how.
struct Side {
  FaceId face;
  EdgeUse use;
};

std::vector<Side> sides(const Brep& brep, EdgeId edge) {
  std::vector<Side> result;
  std::vector<FaceId> faces = brep.edge(edge).faces;
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  for (const FaceId face : faces)
    for (const auto& loop : brep.face(face).loops)
      for (const EdgeUse use : loop)
        if (use.edge == edge) result.push_back({face, use});
  return result;
}

Eigen::Vector3d normal(const Brep& brep, const Side& side, double t) {
  return brep.outward_normal(side.face, brep.domain_point(side.face, side.use, t));
}

double inner_angle(const Brep& brep, const std::vector<Side>& at, double t) {
  const Eigen::Vector3d first = normal(brep, at[0], t), second = normal(brep, at[1], t);
  const Eigen::Vector3d along = brep.tangent(at[0].use.edge, t).normalized() * (at[0].use.reversed ? -1 : 1);
  return std::numbers::pi - std::atan2(first.cross(second).dot(along), first.dot(second));
}

}  // namespace

const char* name(Convexity convexity) {
  switch (convexity) {
    case Convexity::convex:
      return "convex";
    case Convexity::non_convex:
      return "non-convex";
    case Convexity::flat:
      return "flat";
    case Convexity::seam:
      return "seam";
    case Convexity::overused:
      return "overused";
    case Convexity::free:
      break;
  }
  return "free";
}

EdgeAngles edge_angles(const Brep& brep, EdgeId edge, const EdgeAngleOptions& options) {
  if (options.samples < 5)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("samples is {}; at least 5 are needed", options.samples));
  if (!(options.flat > Angle() && options.flat < Angle::degrees(45)))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("flat is {} degrees; it must lie in (0, 45)", options.flat.degrees()));
  const std::vector<Side> at = sides(brep, edge);
  EdgeAngles result;
  if (at.size() > 2) result.convexity = Convexity::overused;
  if (at.size() != 2) return result;
  double low = 2 * std::numbers::pi, high = 0;
  for (int i = 0; i < options.samples; ++i) {
    const double angle = inner_angle(brep, at, double(i) / (options.samples - 1));
    low = std::min(low, angle);
    high = std::max(high, angle);
  }
  result.smallest = Angle::radians(low);
  result.largest = Angle::radians(high);
  const double flat = options.flat.radians();
  if (at[0].face == at[1].face)
    result.convexity = Convexity::seam;
  else if (high > std::numbers::pi + flat)
    result.convexity = Convexity::non_convex;
  else if (low < std::numbers::pi - flat)
    result.convexity = Convexity::convex;
  else
    result.convexity = Convexity::flat;
  return result;
}

std::vector<EdgeAngles> edge_angles(const Brep& brep, const EdgeAngleOptions& options) {
  std::vector<EdgeAngles> result;
  for (std::size_t i = 0; i < brep.edges().size(); ++i)
    result.push_back(edge_angles(brep, EdgeId(static_cast<int>(i)), options));
  return result;
}

}  // namespace isopatch::geometry
