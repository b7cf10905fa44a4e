#pragma once

#include <string>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/topology/edge_graph.hpp"

namespace isopatch::geometry {

/// What a solid's geometry may be off by before it contradicts itself.
struct SoundnessOptions {
  /// Largest distance between a face, its edges and their vertices, as a share of the solid's size. Range
  /// (0, 0.1). The default is the widest that `sew` closes by default: solids of faces that were fitted one
  /// by one reach 1e-3 of it and are usable; whole solids of CAD files reach 2e-4.
  double gap = 5e-3;
};
/// @throws Error invalid_argument  naming field, value and range
void validate(const SoundnessOptions& options);

/// Where an edge lies off a face that uses it.
struct EdgeGap {
  double distance = 0;  ///< m, between the edge and its curve on the face at the same t
  FaceId face;
  EdgeId edge;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< on the edge, m
};

/// The largest of each face's, at 17 places of each use; faces without edges have none.
std::vector<EdgeGap> edge_gaps(const Brep& brep);
/// The largest of all; distance 0 if there is none.
EdgeGap largest_gap(const Brep& brep);

/// Something in which the geometry of a solid contradicts its edge graph or itself, so that no two
/// computations on it need agree.
struct Contradiction {
  std::string text;  ///< names face, edge, place and size
  double size = 0;   ///< m, of a gap
  SolidFault fault;
};

/// Faces off their edges, vertices off the ends of edges, loops that are open in the graph or in their
/// domain, loops that enclose nothing, shells with an impossible V - E + F, and a volume by quadrature that a
/// triangulation does not confirm. In this order; the widest gap first.
/// @param boundary  of the solid's graph; the last two are looked for only if it bounds a solid
/// @throws Error invalid_argument  options out of range
/// @cost  that of the volume and of one triangulation
std::vector<Contradiction> contradictions(const Brep& brep, const BoundaryReport& boundary,
                                          const SoundnessOptions& options = {});

/// @throws SolidError not_manifold  with the problem of the boundary, or the first contradiction and how many
/// more there are; all their places are marked
void require_sound(const Brep& brep, const SoundnessOptions& options = {});

}  // namespace isopatch::geometry
