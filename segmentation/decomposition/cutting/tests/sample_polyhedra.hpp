#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "geometry/brep/make_brep.hpp"

namespace isopatch::segmentation::samples {

/// A prism over a polygon, counter-clockwise, from z = 0 to `height`.
inline geometry::Polyhedron prism(const std::vector<std::array<double, 2>>& polygon, double height) {
  const int n = static_cast<int>(polygon.size());
  geometry::Polyhedron solid;
  solid.vertices.resize(3, 2 * n);
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    const auto& [x, y] = polygon[static_cast<std::size_t>(i)];
    solid.vertices.col(i) << x, y, 0;
    solid.vertices.col(n + i) << x, y, height;
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
  }
  solid.faces = {bottom, top};
  for (int i = 0; i < n; ++i) solid.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  return solid;
}

/// A pyramid over a regular polygon.
inline geometry::Polyhedron pyramid(int n) {
  geometry::Polyhedron solid;
  solid.vertices.resize(3, n + 1);
  std::vector<int> base;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    solid.vertices.col(i) << std::cos(angle), std::sin(angle), 0;
    base.insert(base.begin(), i);
  }
  solid.vertices.col(n) << 0, 0, 1.2;
  solid.faces = {base};
  for (int i = 0; i < n; ++i) solid.faces.push_back({i, (i + 1) % n, n});
  return solid;
}

inline geometry::Polyhedron tetrahedron() {
  return pyramid(3);
}

inline geometry::Polyhedron l_shape() {
  return prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
}

inline geometry::Polyhedron house() {
  return prism({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 1}}, 2);
}

}  // namespace isopatch::segmentation::samples
