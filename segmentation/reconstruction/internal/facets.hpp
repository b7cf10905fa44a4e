#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"

namespace isopatch::segmentation {

/// A facet beside another.
struct FacetLink {
  int other = 0;
  double angle = 0;                                ///< between the normals, rad
  Eigen::Vector3d edge = Eigen::Vector3d::Zero();  ///< from end to end of where they meet
};

/// Triangles in one plane that hang together.
struct Facet {
  std::vector<int> triangles;
  std::vector<int> vertices;  ///< each once
  Eigen::Vector3d normal;     ///< unit, outward
  Eigen::Vector3d middle;     ///< mean of the vertices; of three where there are more than two triangles
  double area = 0;
  std::vector<FacetLink> links;  ///< each neighbour once
};

struct Facets {
  std::vector<Facet> facets;
  std::vector<int> of_triangle;
};

/// The mesh's plane pieces, largest triangles first.
/// @param tolerance  of the vertices' distances from their planes, m
/// @cost  O(T log T)
Facets plane_facets(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                    double tolerance);

/// Who is beside whom, again, from the facets' triangles and normals.
void link_facets(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                 Facets& facets);

}  // namespace isopatch::segmentation
