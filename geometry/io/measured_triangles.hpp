#pragma once

#include <optional>

#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::geometry {

/// Triangles and what one unit of their coordinates measures, where their file says it.
struct MeasuredTriangles {
  TriangleMesh mesh;
  std::optional<double> metres = {};
};

}  // namespace isopatch::geometry
