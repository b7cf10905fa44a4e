#include "geometry/brep/tests/sample_solids.hpp"

#include <set>

namespace isopatch::geometry::test {

// By trial: a triangle belongs to the hull if all other points lie on one side. O(n^4), fine for some twenty
// points.
Polyhedron random_hull(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Polyhedron result;
  result.vertices.resize(3, count);
  for (int i = 0; i < count; ++i)
    result.vertices.col(i) = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count; ++k) {
        const Eigen::Vector3d a = result.vertices.col(i), b = result.vertices.col(j),
                              c = result.vertices.col(k);
        const Eigen::Vector3d n = (b - a).cross(c - a);
        int above = 0, below = 0;
        for (int l = 0; l < count; ++l) {
          if (l == i || l == j || l == k) continue;
          (n.dot(result.vertices.col(l) - a) > 0 ? above : below) += 1;
        }
        if (above == 0) result.faces.push_back({i, j, k});
        if (below == 0) result.faces.push_back({i, k, j});
      }
  return result;
}

}  // namespace isopatch::geometry::test
