#include "geometry/models/model_builder.hpp"

#include <algorithm>

namespace isopatch::geometry {

void ModelBuilder::add(NurbsVolume patch, const std::vector<std::pair<Side, std::string_view>>& names) {
  const PatchId id(static_cast<int>(patches_.patches.size()));
  patches_.patches.push_back(std::move(patch));
  auto& boundaries = patches_.boundaries;
  for (const auto& [side, boundary] : names) {
    auto at = std::find_if(boundaries.begin(), boundaries.end(),
                           [name = boundary](const Boundary& b) { return b.name == name; });
    if (at == boundaries.end()) at = boundaries.insert(at, Boundary{std::string(boundary), {}});
    at->faces.push_back({id, side});
  }
}

}  // namespace isopatch::geometry
