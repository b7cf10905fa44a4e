#pragma once

#include <array>
#include <map>
#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"

namespace isopatch::segmentation {

/// An edge of a divided drawing over which a fillet is.
struct FilletPiece {
  int edge;
  bool left;                            ///< the floor is to the left of the edge, else to its right
  double width;                         ///< of the fillet across the edge, m
  std::array<Eigen::Vector2d, 2> feet;  ///< where the fillet ends on the floor, opposite to the edge's ends
};

/// A divided drawing with a ring of quadrilaterals on the floor's side of each edge under a fillet: as wide
/// as the fillet.
struct FilletRings {
  Quadrangulation quads;
  /// Edges that run beside the piece of the profile that they name: how far to its left, m.
  std::map<int, double> offsets;
  std::map<int, int> radials;  ///< by vertex under a fillet: the edge from there across the ring
  std::map<int, int> rings;    ///< by edge under a fillet: its quadrilateral
  /// A ring that was divided along its edge.
  struct Halves {
    int outer, inner, between;  ///< quadrilaterals from the edge on, and the edge between them
  };
  std::map<int, Halves> halves;               ///< by edge under a fillet; the outer one is its ring
  std::map<int, int> middles, inner_radials;  ///< by vertex under one: where its radial is divided, the rest
};

/// Quadrilaterals that were there keep their numbers, and so do edges but those that end beside a fillet.
/// @param pieces     none twice for one edge
/// @param tolerance  m, of places that are one
/// @throws Error unsupported  rings that end inside the drawing, lie across other outlines or turn sharply
FilletRings fillet_rings(const Profile& profile, const Quadrangulation& quads,
                         const std::vector<FilletPiece>& pieces, double tolerance);

}  // namespace isopatch::segmentation
