#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/sweeps/stack.hpp"
#include "segmentation/sweeps/swept_columns.hpp"

namespace isopatch::segmentation {

/// Divides a solid that is a stack: floors across one direction, walls along it or inclined to it. Bores,
/// slots, pockets, bosses, drafts, countersinks and cones of that direction among them; holes through it and
/// closed edges do not matter. Concave rounds between floors and upright walls are kept, as layers of their
/// own.
///
/// The outlines of all floors are laid over each other, inclined walls where they are lowest; that drawing is
/// divided into quadrilaterals, which are carried from floor to floor. Of several directions the one with the
/// fewest hexahedra is taken. Upright and conical walls are exact; other inclined ones are straight from edge
/// to edge, within 1e-4 of the solid's size of its own.
/// @return  nothing for a solid that is no stack
/// @throws Error unsupported  it looks like one, but an inclined wall is no strip between two edges, walls
/// are not straight, a profile cannot be divided: names the place
std::optional<SweptCells> swept_cells(const geometry::Brep& solid,
                                      const QuadrangulationOptions& options = {.thorough = true});

/// Divides a stack along one given direction, for callers that go on with the cells. Cones may cut off its
/// walls; rounds are not taken.
/// @param lines    on its floors; they become sides of hexahedra
/// @param heights  all columns are divided at, as the frame measures, m
/// @param kept_free  ranges of heights that levels bend away from where they are no floors, m; not of those
/// with such cones
/// @throws Error as above
SweptCells swept_with(const geometry::Brep& solid, const SweepFrame& frame, const std::vector<Line>& lines,
                      const std::vector<double>& heights,
                      const std::vector<std::array<double, 2>>& kept_free = {},
                      const QuadrangulationOptions& options = {});

}  // namespace isopatch::segmentation
