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
  /// Times |places - 4|.
  double length = 0.05;
  /// Each.
  double auxiliary_edge = 0.05, auxiliary_vertex = 0.3;
  /// Times what the sum of |corners - 4| grows by where a face is divided.
  double face_size = 0.1;
  /// Times the root mean square distance of the loop to its best plane, over the root of its area.
  double planarity = 1.0;
  /// Times |alpha1 - alpha2| / alpha, where an auxiliary edge divides a corner alpha of a face; more where it
  /// leaves the face.
  double direction = 0.1;
  /// Times (limit - smallest dihedral angle made) / limit if that is positive; 1 where the cut leaves the
  /// cell.
  double dihedral = 0.5;
  Angle dihedral_limit = Angle::degrees(30);
  /// Each vertex and edge that is new on a face with a neighbour.
  double t_joint = 0.3;
  /// Each flat edge of a piece.
  double flat = 0.2;
  /// Each edge of a piece that is not convex.
  double non_convex = 4.0;
  /// Each base solid that is no hexahedron: its template divides edges, and so its neighbours.
  double divided = 0;
  /// Times the hexahedra estimated for both pieces.
  double hexahedra = 1.0;
  /// Vertices of a piece whose least number of hexahedra is found exactly; range 4 .. 16.
  int exact_up_to = 10;
  bool operator==(const CostOptions&) const = default;
};
/// @throws Error invalid_argument  naming field, value and range
void validate(const CostOptions& options);

/// The terms of what a cutting loop costs, each before its weight.
struct LoopCost {
  double length = 0, auxiliary_edges = 0, auxiliary_vertices = 0, face_size = 0, planarity = 0, direction = 0,
         dihedral = 0, t_joints = 0, flat = 0, hexahedra = 0, non_convex = 0;
  double total = 0;  ///< with the weights
};

/// What a loop costs that cuts a cell. Terms of geometry are 0 where it is not known.
///
/// The cutting surface is taken as plane for angles. An edge of the loop counts as not convex in a piece also
/// where that plane leaves it an angle of 180 degrees or more, unless a face is extended there.
/// @throws Error invalid_argument  points or marks of neighbours that are not as many as vertices or faces
/// @param incidence, pieces  of the graph; of the loop
LoopCost loop_cost(const CellGraph& graph, const CellIncidence& incidence, const CellGeometry& geometry,
                   const CuttingLoop& loop, const CutPieces& pieces, HexahedraCount& count,
                   const CostOptions& options = {});

/// What a cell costs as it is: hexahedra estimated, edges that are not convex, flat ones; with the weights.
double cell_cost(const CellGraph& graph, HexahedraCount& count, const CostOptions& options = {});

}  // namespace isopatch::segmentation
