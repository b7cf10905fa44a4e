#include "segmentation/profiles/quadrangulation.hpp"

#include <algorithm>
#include <numbers>

#include "segmentation/profiles/internal/cell_shape.hpp"

namespace isopatch::segmentation {

QuadShape shape_of(const Profile& profile, const Quadrangulation& quads, int quad) {
  const std::vector<planar::Curve> curves = planar::curves_of(profile);
  std::vector<planar::Node> nodes;
  for (const Eigen::Vector2d& vertex : quads.vertices) nodes.push_back({vertex, false, -1, 0});
  std::array<planar::SideShape, 4> shapes;
  for (std::size_t k = 0; k < 4; ++k) {
    const geometry::EdgeUse& use = quads.quads[static_cast<std::size_t>(quad)].sides[k];
    const QuadEdge& edge = quads.edges[static_cast<std::size_t>(use.edge.value)];
    shapes[k] = planar::side_shape(curves, nodes,
                                   {edge.start, edge.end, edge.profile_edge, edge.low, edge.high, false});
    if (use.reversed) shapes[k] = planar::turned(shapes[k]);
  }
  QuadShape result;
  const std::array<const planar::SideShape*, 4> sides = {&shapes[0], &shapes[1], &shapes[2], &shapes[3]};
  result.jacobian = planar::least_jacobian(sides);
  result.slenderness = planar::slenderness(sides);
  double smallest = planar::refused, largest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double angle = planar::angle_between(shapes[k].start_direction,
                                               shapes[(k + 3) % 4].end_direction + std::numbers::pi);
    smallest = std::min(smallest, angle);
    largest = std::max(largest, angle);
  }
  result.smallest = Angle::radians(smallest);
  result.largest = Angle::radians(largest);
  return result;
}

}  // namespace isopatch::segmentation
