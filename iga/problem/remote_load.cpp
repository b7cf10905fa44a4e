#include "iga/problem/remote_load.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <utility>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "iga/problem/internal/face_quadrature.hpp"

namespace isopatch::iga {
namespace {

// Area, centroid and moments of inertia of some points.
struct AreaMoments {
  double area = 0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the centroid: of r^2 I - r r^T
};

AreaMoments area_moments(const std::vector<FacePoint>& points) {
  AreaMoments result;
  for (const FacePoint& point : points) {
    result.area += point.area;
    result.centroid += point.area * point.place;
  }
  if (result.area > 0) result.centroid /= result.area;
  for (const FacePoint& point : points) {
    const Eigen::Vector3d r = point.place - result.centroid;
    result.inertia += point.area * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return result;
}

}  // namespace

SurfaceLoad remote_load(std::string name, std::vector<geometry::PatchFace> faces, const RemoteForce& remote,
                        const Discretization& discretization, const Region& region) {
  const auto reject = [&](const std::string& what) {
    throw Error(ErrorCode::invalid_argument, fmt::format("'{}': {}", name, what));
  };
  if (!(remote.force.norm() + remote.moment.norm() > 0))
    reject("a remote force needs a force or a moment that is not 0");
  const AreaMoments moments = area_moments(face_points(discretization.patches, faces, region));
  if (!(moments.area > 0)) reject("a remote force needs faces with an area to act on");
  const Eigen::Vector3d centroid = moments.centroid;
  const Eigen::Vector3d arm = remote.point.value_or(centroid) - centroid;
  const Eigen::Vector3d moment = remote.moment + arm.cross(remote.force);
  constexpr double narrow = 1e-12;  // squares of lengths: a strip a millionth as wide as long
  const SymmetricEigen eigen = symmetric_eigen(moments.inertia);
  if (!(eigen.values[0] > narrow * eigen.values[2]))
    reject("the faces are a line, which takes no moment about itself; choose wider ones");
  const Eigen::Vector3d turn =
      eigen.vectors * (eigen.vectors.transpose() * moment).cwiseQuotient(eigen.values);
  const Eigen::Vector3d mean = remote.force / moments.area;
  return {std::move(name), std::move(faces),
          [=](const Eigen::Vector3d& place, const Eigen::Vector3d&) {
            return Eigen::Vector3d(mean + turn.cross(place - centroid));
          },
          region};
}

}  // namespace isopatch::iga
