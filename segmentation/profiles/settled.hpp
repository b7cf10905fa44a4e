#pragma once

#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"

namespace isopatch::segmentation {

/// Moves cuts along their edges, and vertices inside, so that poor quadrilaterals are better in all of
/// several drawings of the same edges at once: outlines of a drafted pocket at its floor and its rim, say.
/// Elsewhere a cut has the same parameter of its edge, and vertices inside follow the mean of their
/// neighbours.
/// @param drawings  the one in which `quads` is, then others with the same vertices, edges and regions;
///                  at least one
/// @param upright   by vertex, in (0, 1]: what Jacobians beside it count
/// @return  the same edges and quadrilaterals; as given where edges have apices
/// @cost    some tenths of a second for 50 quadrilaterals in 5 drawings
Quadrangulation settled(const Quadrangulation& quads, const std::vector<Profile>& drawings,
                        const std::vector<double>& upright);

}  // namespace isopatch::segmentation
