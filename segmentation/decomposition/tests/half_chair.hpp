#pragma once

#include <algorithm>
#include <vector>

#include "geometry/polyhedron.hpp"

namespace isopatch::segmentation::samples {

/// Half of a chair: a seat, a back above its rear end, a leg under each of the two outer corners. Four blocks
/// whose outer faces continue each other, so that two pairs of concave edges at the legs and one at the back
/// are all that joins them. 24 vertices, three edges at each; volume 32.
///
/// x from the back to the front, y from the plane of symmetry outwards, z up.
inline geometry::Polyhedron half_chair() {
  using Face = std::vector<Eigen::Vector3d>;
  const std::vector<Face> faces = {
      {{0, 0, 4}, {4, 0, 4}, {4, 0, 5}, {1, 0, 5}, {1, 0, 9}, {0, 0, 9}},  // in the plane of symmetry
      {{0, 3, 9},
       {1, 3, 9},
       {1, 3, 5},
       {4, 3, 5},
       {4, 3, 0},
       {3, 3, 0},
       {3, 3, 4},
       {1, 3, 4},
       {1, 3, 0},
       {0, 3, 0}},
      {{0, 0, 9}, {0, 3, 9}, {0, 3, 0}, {0, 2, 0}, {0, 2, 4}, {0, 0, 4}},                        // behind
      {{4, 0, 4}, {4, 2, 4}, {4, 2, 0}, {4, 3, 0}, {4, 3, 5}, {4, 0, 5}},                        // in front
      {{0, 2, 4}, {1, 2, 4}, {1, 3, 4}, {3, 3, 4}, {3, 2, 4}, {4, 2, 4}, {4, 0, 4}, {0, 0, 4}},  // under the
                                                                                                 // seat
      {{1, 0, 5}, {4, 0, 5}, {4, 3, 5}, {1, 3, 5}},  // on the seat
      {{1, 0, 5}, {1, 3, 5}, {1, 3, 9}, {1, 0, 9}},  // the back's front
      {{0, 0, 9}, {1, 0, 9}, {1, 3, 9}, {0, 3, 9}},
      {{3, 2, 0}, {4, 2, 0}, {4, 2, 4}, {3, 2, 4}},  // the leg in front
      {{3, 3, 0}, {3, 2, 0}, {3, 2, 4}, {3, 3, 4}},
      {{3, 2, 0}, {3, 3, 0}, {4, 3, 0}, {4, 2, 0}},
      {{0, 2, 0}, {1, 2, 0}, {1, 2, 4}, {0, 2, 4}},  // the leg behind
      {{1, 2, 0}, {1, 3, 0}, {1, 3, 4}, {1, 2, 4}},
      {{0, 2, 0}, {0, 3, 0}, {1, 3, 0}, {1, 2, 0}},
  };
  Face vertices;
  geometry::Polyhedron solid;
  for (const Face& face : faces) {
    std::vector<int>& corners = solid.faces.emplace_back();
    for (const Eigen::Vector3d& place : face) {
      const auto at = std::find(vertices.begin(), vertices.end(), place);
      corners.push_back(static_cast<int>(at - vertices.begin()));
      if (at == vertices.end()) vertices.push_back(place);
    }
  }
  solid.vertices.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    solid.vertices.col(static_cast<Eigen::Index>(i)) = vertices[i];
  return solid;
}

}  // namespace isopatch::segmentation::samples
