#include "app/problem/mass_properties.hpp"

#include <algorithm>

#include "geometry/measures.hpp"

namespace isopatch::app {

std::optional<MassProperties> mass_properties(const geometry::MultiPatch& model,
                                              const std::vector<iga::Material>& materials) {
  if (std::any_of(materials.begin(), materials.end(), [](const auto& m) { return !(m.density > 0); }))
    return std::nullopt;
  Eigen::AlignedBox3d box;
  for (const auto& patch : model.patches()) box.extend(geometry::box(patch));
  const Eigen::Vector3d origin = box.center();
  MassProperties result;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (std::size_t p = 0; p < materials.size(); ++p) {
    const geometry::VolumeMoments moments = geometry::volume_moments(model.patches()[p], origin);
    result.mass += materials[p].density * moments.volume;
    first += materials[p].density * moments.first;
    second += materials[p].density * moments.second;
  }
  const Eigen::Vector3d offset = first / result.mass;
  result.centre = origin + offset;
  second -= result.mass * offset * offset.transpose();
  result.inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  return result;
}

}  // namespace isopatch::app
