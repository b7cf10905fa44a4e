#include "segmentation/decomposition/cutting/corner_shape.hpp"

#include <Eigen/Geometry>
#include <array>

#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"

namespace isopatch::segmentation {
namespace {

// Corners of less volume fold a patch, or let it degenerate.
constexpr double least_corner_volume = 1e-3;

// The volume that unit vectors along the three edges of a corner span, in [-1, 1]: a hexahedron's Jacobian
// has its sign there.
double corner_volume(const CellShapes& shapes, const CellSides& sides, const CellIncidence& incidence,
                     VertexId vertex) {
  std::array<Eigen::Vector3d, 3> away;
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeId edge = incidence.edges_at(vertex)[k];
    const std::vector<geometry::EdgeUse>& chain = sides.edges[static_cast<std::size_t>(edge.value)];
    const bool at_start = sides.graph.edge(edge).start == vertex;
    const geometry::EdgeUse use = at_start ? chain.front() : chain.back();
    const Eigen::Vector3d along = shapes.tangent(use.edge, use.reversed == at_start ? 1 : 0).normalized();
    away[k] = use.reversed == at_start ? Eigen::Vector3d(-along) : along;
  }
  return -away[0].dot(away[1].cross(away[2]));  // counter-clockwise seen from outside
}

}  // namespace

bool corners_open(const CellShapes& shapes, const CellSides& sides) {
  const CellIncidence incidence(sides.graph);
  for (int v = 0; v < sides.graph.vertex_count; ++v)
    if (incidence.edges_at(VertexId(v)).size() == 3 &&
        !(corner_volume(shapes, sides, incidence, VertexId(v)) > least_corner_volume))
      return false;
  return true;
}

}  // namespace isopatch::segmentation
