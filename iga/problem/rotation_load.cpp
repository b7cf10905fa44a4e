#include "iga/problem/rotation_load.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::iga {

std::vector<VolumeLoad> rotation_load(const std::string& name, const std::vector<PatchId>& patches,
                                      const Rotation& rotation, const std::vector<Material>& materials) {
  if (!(rotation.axis.norm() > 0))
    throw Error(ErrorCode::invalid_argument, fmt::format("'{}': the axis has no direction", name));
  const Eigen::Vector3d axis = rotation.axis.normalized();
  std::vector<VolumeLoad> loads;
  for (const PatchId patch : patches) {
    const Material& material = materials.at(static_cast<std::size_t>(patch.value));
    if (!(material.density > 0))
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("'{}': patch {} has no density; rotation needs one in its material", name,
                              patch.value));
    const double factor = material.density * rotation.speed * rotation.speed;
    loads.push_back({name, {patch}, [=, point = rotation.point](const Eigen::Vector3d& place) {
                       const Eigen::Vector3d arm = place - point;
                       return Eigen::Vector3d(factor * (arm - axis * axis.dot(arm)));
                     }});
  }
  return loads;
}

}  // namespace isopatch::iga
