#pragma once

#include <array>
#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"
#include "segmentation/sweeps/internal/swept_drawing.hpp"

namespace isopatch::segmentation {

/// The lowest and the highest height at which tracks are known, m; there are some.
std::array<double, 2> range_of(const Tracks& tracks);

/// The profile of a drawing where it is at a height: the same edges and regions, what is on inclined walls
/// moved along them.
Profile profile_at(const geometry::Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                   double height);

/// The profile where walls begin and end, at floors and half-way up.
struct ProfilesAtHeights {
  std::vector<double> heights;  ///< ascending, m
  std::vector<Profile> profiles;
};
ProfilesAtHeights profiles_at_heights(const geometry::Brep& solid, const SweepFrame& frame,
                                      const SweptDrawing& drawing);

/// Quadrilaterals of the profile at a height as those of the drawing: vertices inside are moved to where they
/// are drawn.
Quadrangulation as_drawn(const geometry::Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                         const Quadrangulation& at_height, double height);

/// What stands on a divided drawing.
struct StandingQuads {
  double least_jacobian = 1;  ///< scaled, about: of the quadrilaterals at these heights, each times the
                              ///< cosine of the steepest way up beside it
  int hexahedra = 0;
  double slenderness = 0;       ///< sum over the hexahedra of the squared logarithm of their quadrilaterals'
  std::vector<double> upright;  ///< by vertex: the least cosine of its way up
};

/// @cost  some milliseconds for 100 quadrilaterals, and projections onto edges that move
StandingQuads standing_quads(const geometry::Brep& solid, const SweepFrame& frame,
                             const SweptDrawing& drawing, const ProfilesAtHeights& there,
                             const Quadrangulation& quads);

}  // namespace isopatch::segmentation
