#pragma once

#include <array>

#include "geometry/brep/read_brep.hpp"
#include "geometry/hex/cube.hpp"

namespace isopatch::segmentation {

/// Finds the unit cube in a solid: its faces by side, right-handed by the sense of their loops. The solid's
/// first vertex becomes corner 0, its neighbours' numbers decide on the directions.
/// @throws Error unsupported      as `refuse_faces`; a solid that has not the graph of a cube
/// @throws Error not_conforming   an open shell, a non-manifold edge, naming the edge and its faces; faces
/// that look to different sides
/// @throws Error invalid_argument an edge of no length, a face whose outline crosses itself, a solid of no
/// volume. All messages name solid, face and vertices.
std::array<FaceId, 6> cube_sides(const geometry::BrepFile& solid);

/// The vertices at the corners of a cube whose faces are known.
std::array<VertexId, 8> cube_vertices(const geometry::Brep& brep, const std::array<FaceId, 6>& sides);

}  // namespace isopatch::segmentation
