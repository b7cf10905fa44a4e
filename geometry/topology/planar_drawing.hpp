#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/topology/edge_graph.hpp"
#include "geometry/topology/graph_connectivity.hpp"

namespace isopatch::geometry {

struct PlanarDrawingOptions {
  /// The face that becomes the outside; by default the one with most corners.
  std::optional<FaceId> outer;
};

/// A straight-line drawing of a 3-connected edge graph in the unit disc: no edges cross, every face is
/// convex.
///
/// The outer face's corners lie on the unit circle; each other vertex is the mean of its neighbours. Faces
/// appear clockwise as seen from inside the solid, that is as one sees them looking through the outer face.
/// @return  positions of the vertices, (2, V)
/// @throws Error not_three_connected  for other graphs, which may collapse
/// @cost    a sparse factorization with V unknowns
/// @source  Tutte, How to draw a graph, 1963; the isogeometric segmentation pipeline, Fig. 5
Eigen::Matrix2Xd planar_drawing(const EdgeGraph& graph, const ConnectivityReport& report,
                                const PlanarDrawingOptions& options = {});

}  // namespace isopatch::geometry
