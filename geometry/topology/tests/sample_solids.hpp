#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/polyhedron.hpp"

namespace isopatch::geometry::test {

/// [0, a] x [0, b] x [0, c].
inline Polyhedron block(double a, double b, double c) {
  Polyhedron result;
  result.vertices.resize(3, 8);
  for (int i = 0; i < 8; ++i) result.vertices.col(i) << a * (i & 1), b * ((i >> 1) & 1), c * ((i >> 2) & 1);
  result.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return result;
}

/// Over a regular n-gon of radius 1, height h.
inline Polyhedron prism(int n, double h = 1) {
  Polyhedron result;
  result.vertices.resize(3, 2 * n);
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    result.vertices.col(i) << std::cos(angle), std::sin(angle), 0;
    result.vertices.col(n + i) << std::cos(angle), std::sin(angle), h;
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
    const int next = (i + 1) % n;
    result.faces.push_back({i, next, n + next, n + i});
  }
  result.faces.push_back(bottom);
  result.faces.push_back(top);
  return result;
}

/// Over a regular n-gon of radius 1, apex at height h.
inline Polyhedron pyramid(int n, double h = 1) {
  Polyhedron result;
  result.vertices.resize(3, n + 1);
  std::vector<int> bottom;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    result.vertices.col(i) << std::cos(angle), std::sin(angle), 0;
    bottom.insert(bottom.begin(), i);
    result.faces.push_back({i, (i + 1) % n, n});
  }
  result.vertices.col(n) << 0, 0, h;
  result.faces.push_back(bottom);
  return result;
}

/// An L of three unit squares, one thick; the edge between (1, 1, 0) and (1, 1, 1) is not convex.
inline Polyhedron l_shape() {
  const std::vector<Eigen::Vector2d> outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const int n = 6;
  Polyhedron result;
  result.vertices.resize(3, 2 * n);
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    result.vertices.col(i) << outline[static_cast<std::size_t>(i)], 0;
    result.vertices.col(n + i) << outline[static_cast<std::size_t>(i)], 1;
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
    result.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  result.faces.push_back(bottom);
  result.faces.push_back(top);
  return result;
}

/// A frame: n x m grid of quadrilaterals around a torus, with plane faces if n = 4 and m = 4 are sections by
/// planes; here every quadrilateral is cut in two triangles. Genus 1.
inline Polyhedron triangulated_torus(int n, int m) {
  Polyhedron result;
  result.vertices.resize(3, n * m);
  const auto id = [&](int i, int j) { return (i % n) * m + j % m; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / m;
      result.vertices.col(id(i, j)) << (3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u),
          std::sin(v);
      result.faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      result.faces.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return result;
}

/// A convex polyhedron with `count` random vertices on the unit sphere: its hull, triangles. Seeded.
/// By trial: a triangle belongs to the hull if all other points lie on one side. O(n^4), fine for some twenty
/// points.
inline Polyhedron random_hull(int count, unsigned seed) {
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

/// Signed volume by the divergence theorem over a fan of triangles of each face; exact for plane faces.
inline double polyhedron_volume(const Polyhedron& polyhedron) {
  double sum = 0;
  for (const auto& face : polyhedron.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      sum += polyhedron.vertices.col(face[0]).dot(
                 polyhedron.vertices.col(face[i]).cross(polyhedron.vertices.col(face[i + 1]))) /
             6;
  return sum;
}

inline double polyhedron_area(const Polyhedron& polyhedron) {
  double sum = 0;
  for (const auto& face : polyhedron.faces) {
    Eigen::Vector3d total = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      total += (polyhedron.vertices.col(face[i]) - polyhedron.vertices.col(face[0]))
                   .cross(Eigen::Vector3d(polyhedron.vertices.col(face[i + 1]) -
                                          polyhedron.vertices.col(face[0]))) /
               2;
    sum += total.norm();
  }
  return sum;
}

}  // namespace isopatch::geometry::test
