#include "iga/problem/hydrostatic_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/problem/internal/face_quadrature.hpp"

namespace isopatch::iga {

double pressure(const Liquid& liquid, const Eigen::Vector3d& place) {
  return std::max(0.0, liquid.density * (place - liquid.surface).dot(liquid.gravity));
}

SurfaceLoad hydrostatic_load(std::string name, std::vector<geometry::PatchFace> faces, const Liquid& liquid,
                             const Discretization& discretization, const Region& region) {
  const auto reject = [&](const std::string& what) {
    throw Error(ErrorCode::invalid_argument, fmt::format("'{}': {}", name, what));
  };
  if (!(liquid.density > 0))
    reject(fmt::format("a liquid needs a positive density, not {} kg/m^3", liquid.density));
  if (!(liquid.gravity.norm() > 0)) reject("a liquid needs a gravity that is not 0");
  const Region wet = region & half_space(liquid.surface, liquid.gravity);
  const std::vector<FacePoint> points = face_points(discretization.patches, faces, wet);
  if (std::none_of(points.begin(), points.end(),
                   [&](const FacePoint& point) { return pressure(liquid, point.place) > 0; }))
    reject("the liquid wets none of the faces: all lie above its surface; look at surface and gravity");
  return {std::move(name), std::move(faces),
          [liquid](const Eigen::Vector3d& place, const Eigen::Vector3d& normal) {
            return Eigen::Vector3d(-pressure(liquid, place) * normal);
          },
          wet};
}

}  // namespace isopatch::iga
