#pragma once

#include <array>
#include <utility>
#include <vector>

#include "geometry/multi_patch.hpp"

namespace isopatch::iga {

/// One knot vector per direction and patch: entry 3 * patch + direction.
using DirectionKnots = std::vector<geometry::KnotVector>;

/// One direction of the first face of an interface and the direction of the second along which it runs, as
/// entries 3 * patch + direction.
struct TiedPair {
  std::size_t first;
  std::size_t second;
  bool flipped;  ///< whether the one runs against the other
};
std::array<TiedPair, 2> tied_pairs(const geometry::Interface& interface);

/// Group of each direction (entry 3 * patch + direction), equal for directions that interfaces tie together.
/// Classes are named by their smallest member.
std::vector<int> tied_directions(const geometry::MultiPatch& model);

/// The smallest spaces that contain the given ones and have the same traces on both sides of every interface.
/// @throws Error not_conforming if knots of a neighbour cannot be matched
DirectionKnots matched(const geometry::MultiPatch& model, DirectionKnots knots);

/// Checks that patches match at interfaces: traces with as many functions, and weights that are proportional.
/// @throws Error not_conforming naming the two faces
void check_traces(const geometry::MultiPatch& model, const std::vector<geometry::NurbsVolume>& patches);

/// Control points that an interface identifies: pairs of local indices in the first and in the second patch.
/// @param sizes  functions per direction of every patch
std::vector<std::pair<int, int>> matching_control_points(const geometry::Interface& interface,
                                                         const std::vector<std::array<int, 3>>& sizes);

/// Functions per direction of every patch.
std::vector<std::array<int, 3>> sizes_of(const std::vector<geometry::NurbsVolume>& patches);

}  // namespace isopatch::iga
