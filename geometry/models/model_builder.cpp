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

void ModelBuilder::join(PatchFace first, PatchFace second, const FaceOrientation& orientation) {
  patches_.interfaces.push_back({first, second, orientation});
}

void ModelBuilder::join_row(int first, int step, int count, int direction, bool closed) {
  for (int i = 0; i + 1 < count + (closed ? 1 : 0); ++i)
    join({PatchId(first + step * i), side_of(direction, true)},
         {PatchId(first + step * ((i + 1) % count)), side_of(direction, false)});
}

void ModelBuilder::join_grid(const std::array<int, 3>& counts, const std::array<bool, 3>& closed) {
  const std::array<int, 3> steps = {1, counts[0], counts[0] * counts[1]};
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t a = (d + 1) % 3, b = (d + 2) % 3;
    for (int j = 0; j < counts[b]; ++j)
      for (int i = 0; i < counts[a]; ++i)
        join_row(i * steps[a] + j * steps[b], steps[d], counts[d], static_cast<int>(d), closed[d]);
  }
}

}  // namespace isopatch::geometry
