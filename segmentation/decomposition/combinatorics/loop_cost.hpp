#pragma once

#include <Eigen/Core>
#include <vector>

#include "segmentation/decomposition/combinatorics/cut_along.hpp"
#include "segmentation/decomposition/combinatorics/hexahedra_count.hpp"

namespace isopatch::segmentation {

/// What is known of a cell in space. Empty where nothing is.
struct CellGeometry {
  Eigen::Matrix3Xd points;          ///< of the vertices, (3, V), or of no columns
  std::vector<bool> has_neighbour;  ///< of each face: another cell lies behind it; or empty
};

/// Weights of what makes a loop worse, in hexahedra: a cost of 1 weighs as much as one hexahedron more.
struct CostOptions {
  double length = 0.05;           ///< times |places - 4|
  double auxiliary_edge = 0.05;   ///< each
  double auxiliary_vertex = 0.3;  ///< each
  double face_size = 0.1;         ///< times what |corners - 4| of the faces grows by where a face is divided
  double planarity =
      1.0;  ///< times the root mean square distance to the best plane over the root of the area
  double direction =
      0.1;                ///< times |alpha1 - alpha2| / alpha, where an auxiliary edge divides a corner alpha
  double dihedral = 0.5;  ///< times (limit - smallest dihedral angle made) / limit, if that is positive
  Angle dihedral_limit = Angle::degrees(30);
  double t_joint = 0.3;     ///< each vertex and edge that is new on a face with a neighbour
  double hexahedra = 1.0;   ///< times the estimate of both pieces
  double non_convex = 4.0;  ///< each edge that is not convex in a piece, before extensions
  int exact_up_to =
      9;  ///< vertices of a piece whose least number of hexahedra is found exactly; range 4 .. 16
};
/// @throws Error invalid_argument  naming field, value and range
void validate(const CostOptions& options);

/// Each term before its weight.
struct LoopCost {
  double length = 0, auxiliary_edges = 0, auxiliary_vertices = 0, face_size = 0, planarity = 0, direction = 0,
         dihedral = 0, t_joints = 0, hexahedra = 0, non_convex = 0;
  double total = 0;  ///< with the weights
};

/// What a loop costs that cuts a cell. Terms of geometry are 0 where it is not known.
/// @param pieces  of that loop
LoopCost loop_cost(const CellGraph& graph, const CellGeometry& geometry, const CuttingLoop& loop,
                   const CutPieces& pieces, HexahedraCount& count, const CostOptions& options = {});

}  // namespace isopatch::segmentation
