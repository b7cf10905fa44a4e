#pragma once

#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::segmentation::test {

/// A grid of n x n squares, each two triangles, as points say; vertices n + 1 in a row.
void add_grid(geometry::TriangleMesh& mesh, int n, const auto& point) {
  const auto first = static_cast<int>(mesh.vertices.cols());
  const Eigen::Index triangles = mesh.triangles.cols();
  mesh.vertices.conservativeResize(3, first + (n + 1) * (n + 1));
  mesh.triangles.conservativeResize(3, triangles + 2 * n * n);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      mesh.vertices.col(first + i + (n + 1) * j) = point(double(i) / n, double(j) / n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = first + i + (n + 1) * j, b = a + 1, c = b + n + 1, d = c - 1;
      mesh.triangles.col(triangles + 2 * (i + n * j)) << a, b, c;
      mesh.triangles.col(triangles + 2 * (i + n * j) + 1) << a, c, d;
    }
}

}  // namespace isopatch::segmentation::test
