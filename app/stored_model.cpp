#include "app/stored_model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/internal/json_values.hpp"
#include "geometry/measures.hpp"

namespace isopatch::app {
namespace {

// Gaps known to be part of the model are no reason to take it apart.
Tolerance tolerance_for(const std::vector<geometry::NurbsVolume>& patches, const Json& summary) {
  Tolerance tolerance;
  const auto gap = Json::json_pointer("/model/largest_gap");
  if (summary.is_discarded() || !summary.contains(gap) || !summary[gap].is_number()) return tolerance;
  Eigen::AlignedBox3d all;
  for (const auto& patch : patches) all.extend(geometry::box(patch));
  const double relative = 1.5 * summary[gap].get<double>() / all.diagonal().norm();
  tolerance.same_point = std::clamp(relative, tolerance.same_point, 0.009);
  tolerance.near_miss = std::max(tolerance.near_miss, 2 * tolerance.same_point);
  return tolerance;
}

}  // namespace

std::string StoredModel::label(geometry::PatchFace face) const {
  if (was_left_handed[static_cast<std::size_t>(face.patch.value)] && direction(face.side) == 0)
    face.side = opposite(face.side);
  return fmt::format("{}:{}", face.patch.value, name(face.side));
}

geometry::Parameter<3> StoredModel::renamed(int patch, geometry::Parameter<3> parameter) const {
  const auto& knots = model.patch(PatchId(patch)).knots(0);
  if (was_left_handed[static_cast<std::size_t>(patch)])
    parameter[0] = knots.first() + knots.last() - parameter[0];
  return parameter;
}

std::vector<bool> left_handed_patches(const std::string& summary, std::size_t patches) {
  std::vector<bool> result(patches, false);
  const Json json = Json::parse(summary, nullptr, false);
  const auto turned = Json::json_pointer("/model/left_handed_patches");
  if (json.is_discarded() || !json.contains(turned)) return result;
  for (const Json& index : json[turned])
    if (index.is_number_unsigned() && index.get<std::size_t>() < patches)
      result[index.get<std::size_t>()] = true;
  return result;
}

StoredModel stored_model(const std::vector<geometry::NurbsVolume>& patches, const std::string& summary) {
  const Json json = Json::parse(summary, nullptr, false);
  return {geometry::connect({patches, {}, {}}, tolerance_for(patches, json)),
          left_handed_patches(summary, patches.size())};
}

}  // namespace isopatch::app
