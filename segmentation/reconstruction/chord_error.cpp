#include "segmentation/reconstruction/internal/chord_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isopatch::segmentation {

double chord_error(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                   const Regions& regions, int region) {
  double result = 0;
  for (const int t : regions.regions[static_cast<std::size_t>(region)].triangles)
    for (int i = 0; i < 3; ++i) {
      const int other = neighbours.across[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)].triangle;
      if (regions.of_triangle[static_cast<std::size_t>(other)] != region) continue;
      const Eigen::Vector3d a = geometry::area_vector(mesh, t), b = geometry::area_vector(mesh, other);
      const double edge =
          (mesh.vertices.col(mesh.triangles((i + 1) % 3, t)) - mesh.vertices.col(mesh.triangles(i, t)))
              .norm();
      const double width = (a.norm() + b.norm()) / 2 / edge, angle = std::atan2(a.cross(b).norm(), a.dot(b));
      result = std::max(result, width * angle / 8);
    }
  return result;
}

}  // namespace isopatch::segmentation
