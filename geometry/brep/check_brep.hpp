#pragma once

#include <string>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/contradictions.hpp"
#include "geometry/brep/edge_angles.hpp"
#include "geometry/topology/edge_graph.hpp"
#include "geometry/topology/graph_connectivity.hpp"

namespace isopatch::geometry {

/// Where on the way from a solid to patches a solid can go in. Each is nearer to the end than the one before.
enum class BrepStage {
  repair,         ///< the faces do not bound one solid, or the geometry contradicts itself
  preprocessing,  ///< holes, cavities, inner loops, seams or a graph that is not 3-connected have to go first
  decomposition,  ///< cutting loops can take it apart
  parameterization,  ///< a topological hexahedron
};
const char* name(BrepStage stage);

/// What a solid is like.
struct BrepReport {
  BoundaryReport boundary;
  TopologyReport topology;
  ConnectivityReport connectivity;
  std::vector<EdgeAngles> angles;  ///< of each edge
  double volume = 0;               ///< m^3; 0 for an open boundary
  double area = 0;                 ///< m^2
  double volume_error = 0;         ///< m^3, estimate of the quadrature
  double area_error = 0;           ///< m^2
  double largest_gap = 0;          ///< m, between an edge and its curve on a face
  EdgeGap gap;                     ///< the same, and where it is
  EdgeId shortest_edge;
  std::vector<Contradiction> contradictions;  ///< of the geometry with itself
  BrepStage stage = BrepStage::repair;
  std::vector<std::string>
      findings;  ///< sentences: what stands between the solid and the next stage, entities named

  int count(Convexity convexity) const;
};

struct CheckOptions {
  EdgeAngleOptions angles = {};
  SoundnessOptions soundness = {};
};

/// Checks a solid: closed, manifold, oriented, one shell, contractible, simple and 3-connected, angles at
/// edges; whether the geometry is what the edge graph says and the figures have converged.
/// @cost  that of the volume and of one triangulation, and samples x edges evaluations
BrepReport check(const Brep& brep, const CheckOptions& options = {});

}  // namespace isopatch::geometry
