#include "segmentation/decomposition/given_plane.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::PlaneSurface;

PlaneSurface plane(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d normal = direction.normalized(), x = normal.unitOrthogonal();
  return {point, x, normal.cross(x)};
}

PlaneSurface plane_of_face(const Brep& solid, const std::string& name) {
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f) {
    const FaceId face(f);
    if (solid.face(face).name != name && name != fmt::format("face {}", f)) continue;
    const auto carrier = solid.carrier(face);
    if (!carrier || carrier->kind != geometry::SurfaceKind::plane)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("{} is not plane, so that it cannot be extended as a cut",
                              geometry::describe(solid, face)));
    return plane(carrier->origin, carrier->axis);
  }
  throw Error(ErrorCode::invalid_argument,
              fmt::format("there is no face '{}' to be extended; `isopatch info` lists the faces", name));
}

PlaneSurface plane_through(const std::vector<Eigen::Vector3d>& points, double size) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) middle += point / static_cast<double>(points.size());
  Eigen::Matrix3Xd from_middle(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    from_middle.col(static_cast<Eigen::Index>(i)) = points[i] - middle;
  const LeftSingular parts = left_singular(from_middle);
  if (!(parts.values[1] > 1e-6 * size))
    throw Error(ErrorCode::invalid_argument, "the points of a cut are on a line; three off it are needed");
  const Eigen::Vector3d normal = parts.vectors.col(2);
  for (const Eigen::Vector3d& point : points)
    if (const double off = std::abs((point - middle).dot(normal)); off > 1e-6 * size)
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("the points of a cut lie in no plane: ({:.6g}, {:.6g}, {:.6g}) m is {:.3g} m off",
                      point.x(), point.y(), point.z(), off));
  return plane(middle, normal);
}

}  // namespace

void validate(const GivenPlane& given) {
  const int ways = static_cast<int>(given.normal.has_value()) + static_cast<int>(!given.face.empty()) +
                   static_cast<int>(!given.through.empty());
  if (ways != 1)
    throw Error(ErrorCode::invalid_argument, "a plane is given by one of normal, face and through");
  if (given.point && !given.normal)
    throw Error(ErrorCode::invalid_argument, "a plane with a point needs its normal");
  if (given.normal && !(given.normal->norm() > 0))
    throw Error(ErrorCode::invalid_argument, "the normal of a plane has no length");
  if (!given.through.empty() && given.through.size() < 3)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("a plane goes through three points or more; {} are given", given.through.size()));
}

PlaneSurface plane_of(const Brep& solid, const GivenPlane& given) {
  validate(given);
  if (!given.face.empty()) return plane_of_face(solid, given.face);
  if (!given.through.empty()) return plane_through(given.through, solid.size());
  const auto box = solid.box();
  return plane(given.point.value_or((box[0] + box[1]) / 2), *given.normal);
}

}  // namespace isopatch::segmentation
