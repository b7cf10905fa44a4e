#pragma once

#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::segmentation::test {

/// A grid of m x n quadrangles, each two triangles, as points say; vertices m + 1 in a row.
void add_grid(geometry::TriangleMesh& mesh, int m, int n, const auto& point) {
  const auto first = static_cast<int>(mesh.vertices.cols());
  const Eigen::Index triangles = mesh.triangles.cols();
  mesh.vertices.conservativeResize(3, first + (m + 1) * (n + 1));
  mesh.triangles.conservativeResize(3, triangles + 2 * m * n);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= m; ++i)
      mesh.vertices.col(first + i + (m + 1) * j) = point(double(i) / m, double(j) / n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      const int a = first + i + (m + 1) * j, b = a + 1, c = b + m + 1, d = c - 1;
      mesh.triangles.col(triangles + 2 * (i + m * j)) << a, b, c;
      mesh.triangles.col(triangles + 2 * (i + m * j) + 1) << a, c, d;
    }
}

/// One of n x n.
void add_grid(geometry::TriangleMesh& mesh, int n, const auto& point) {
  add_grid(mesh, n, n, point);
}

}  // namespace isopatch::segmentation::test
