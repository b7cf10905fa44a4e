#include "segmentation/sweeps/in_the_way.hpp"

#include <utility>

#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {

std::optional<InTheWay> least_in_the_way(const geometry::Brep& solid) {
  std::optional<InTheWay> best;
  for (const Eigen::Vector3d& along : floor_directions(solid)) {
    std::vector<FaceId> faces = neither_floor_nor_wall(solid, along);
    if (!best || faces.size() < best->faces.size()) best = InTheWay{along, std::move(faces)};
  }
  return best;
}

}  // namespace isopatch::segmentation
