#pragma once

#include <array>
#include <vector>

#include "geometry/polyhedron.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::segmentation::samples {

using geometry::test::l_shape;
using geometry::test::pyramid;
using geometry::test::random_hull;

/// A prism over a polygon, counter-clockwise, from z = 0 to `height`. Face 0 is the bottom, face 1 the top.
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

inline geometry::Polyhedron house() {
  return prism({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 1}}, 2);
}

/// Half a square pot, halved along its diagonal.
inline geometry::Polyhedron half_pot() {
  geometry::Polyhedron solid;
  solid.vertices.resize(3, 12);
  solid.vertices << 0, 5, 0, 0, 5, 0, 1, 4, 1, 1, 4, 1,  //
      0, 5, 5, 0, 5, 5, 1, 4, 4, 1, 4, 4,                //
      0, 0, 0, 4, 4, 4, 1, 1, 1, 4, 4, 4;
  solid.faces = {{0, 2, 1},     {6, 7, 8},      {3, 9, 11, 10, 4, 5}, {0, 1, 4, 10, 7, 6, 9, 3},
                 {6, 8, 11, 9}, {7, 10, 11, 8}, {0, 3, 5, 2},         {1, 2, 5, 4}};
  return solid;
}

/// A house with a notch in its ridge, between whose ends both halves of the roof meet: they share two
/// vertices without an edge between them.
inline geometry::Polyhedron house_with_a_notch() {
  geometry::Polyhedron solid;
  solid.vertices.resize(3, 14);
  solid.vertices << 0, 0, 0, 0, 0, 3, 3, 3, 3, 3, 1, 2, 1.5, 1.5,  //
      0, 2, 2, 1, 0, 0, 2, 2, 1, 0, 1, 1, 0.5, 1.5,                //
      0, 0, 1, 2, 1, 0, 0, 1, 2, 1, 2, 2, 1.5, 1.5;
  solid.faces = {{0, 4, 3, 2, 1},          {5, 6, 7, 8, 9},          {0, 1, 6, 5}, {1, 2, 7, 6}, {0, 5, 9, 4},
                 {2, 3, 10, 13, 11, 8, 7}, {9, 8, 11, 12, 10, 3, 4}, {10, 12, 13}, {11, 13, 12}};
  return solid;
}

/// The same with roofs that are no planes, so that no straight edge divides them.
inline geometry::Polyhedron house_with_a_bent_notch() {
  geometry::Polyhedron solid = house_with_a_notch();
  solid.vertices(1, 12) -= 0.1;
  solid.vertices(1, 13) += 0.1;
  return solid;
}

}  // namespace isopatch::segmentation::samples
