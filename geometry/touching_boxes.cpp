#include "geometry/touching_boxes.hpp"

#include <algorithm>
#include <numeric>

namespace isopatch::geometry {

std::vector<std::pair<std::size_t, std::size_t>> touching_boxes(const std::vector<Eigen::AlignedBox3d>& boxes,
                                                                double distance) {
  std::vector<std::size_t> by_start(boxes.size());
  std::iota(by_start.begin(), by_start.end(), std::size_t{0});
  std::sort(by_start.begin(), by_start.end(),
            [&](std::size_t a, std::size_t b) { return boxes[a].min().x() < boxes[b].min().x(); });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t k = 0; k < by_start.size(); ++k)
    for (std::size_t l = k + 1; l < by_start.size(); ++l) {
      const Eigen::AlignedBox3d& first = boxes[by_start[k]];
      const Eigen::AlignedBox3d& second = boxes[by_start[l]];
      if (second.min().x() > first.max().x() + distance) break;
      if (first.squaredExteriorDistance(second) <= distance * distance)
        pairs.push_back(std::minmax(by_start[k], by_start[l]));
    }
  return pairs;
}

}  // namespace isopatch::geometry
