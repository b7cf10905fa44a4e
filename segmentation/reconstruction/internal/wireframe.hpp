#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "geometry/base/ids.hpp"
#include "geometry/brep/brep_parts.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "geometry/splines/nurbs.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// Where two regions meet, from corner to corner.
struct WireEdge {
  int start = 0, end = 0;                     ///< vertices of the wireframe
  std::vector<Eigen::Vector3d> points;        ///< along it, m, both ends among them; none: a pole
  std::vector<int> of_mesh;                   ///< the mesh's vertex at each point; -1: it has none there
  std::array<int, 2> regions{};               ///< to the left and to the right; one twice for a seam
  bool free_start = false;                    ///< closed, and its vertex is no corner
  std::optional<geometry::NurbsCurve> curve;  ///< from start to end, of an edge of a freeform face
  Eigen::Matrix3Xd on_carrier;                ///< or points from start to end, where its other face curves
};

/// The edges of regions and their loops, as of a B-rep, but with points of the mesh.
struct Wireframe {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> regions_at;  ///< by vertex
  std::vector<WireEdge> edges;
  std::vector<std::vector<std::vector<geometry::EdgeUse>>> loops;  ///< by region, the region to the left
};

/// @param mesh  closed; triangles of a region hang together
/// @cost  O(T)
Wireframe wireframe(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                    const Regions& regions);

/// Makes two edges of one at a point of its segment that begins at `segment`, in all loops; a closed edge
/// without a corner gets its vertex there instead. The number of the vertex.
int split(Wireframe& wires, int edge, std::size_t segment, const Eigen::Vector3d& point);

}  // namespace isopatch::segmentation
