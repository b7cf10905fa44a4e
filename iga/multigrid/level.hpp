#pragma once

#include <optional>
#include <vector>

#include "iga/coupling/free_directions.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/distribution/distribution.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/shared_rows.hpp"

namespace isopatch::iga {

/// A level of the multigrid: a space of displacements on all patches, coupled by elimination. The finest one
/// is the solution space. A process has the rows of all patches that it integrates in part.
struct Level {
  std::vector<PatchSpace> spaces;  ///< of all patches
  std::vector<int> first_node;     ///< of each patch, and the number of nodes at the end
  std::vector<int> row_of_node;    ///< local block row of every node, -1 where another process has it
  std::vector<int> global_of;      ///< of every node, in the whole system
  solvers::SharedRows rows;
  std::vector<PatchLayers> parts;  ///< what this process integrates
  std::vector<bool> is_primary;    ///< per patch: whether this is the process that acts for it
  FreeDirections free;             ///< of the local rows
};

/// The solution space as a level.
/// @param spaces  of all patches; what they point to must outlive the level
/// @param frames  one per global node
Level finest_level(const std::vector<PatchSpace>& spaces, const GlobalNodes& global,
                   const std::vector<SupportFrame>& frames, const Distribution& distribution,
                   const solvers::Processes& processes);

/// The next coarser level: half the elements of `level` per direction; where only one is left, degree 2 and
/// then 1. Empty if nothing is left to coarsen.
///
/// Nested in `level`: rational functions keep their denominators, so rigid motions stay free of energy, as
/// long as the coarser functions of every patch can make them; below that all are polynomial.
///
/// @param finest   from which the supports are taken
/// @param frames   of the finest level's global nodes
/// @cost  O(nodes of the finest level) at most
std::optional<Level> coarser_level(const geometry::MultiPatch& model, const Level& level, const Level& finest,
                                   const std::vector<SupportFrame>& frames, const Distribution& distribution,
                                   const solvers::Processes& processes);

/// Coarsens a knot vector: drops every second break, from both ends alike, so that the two sides of an
/// interface stay matched however they are oriented. Kept breaks keep their multiplicity.
geometry::KnotVector coarser_knots(const geometry::KnotVector& knots);

}  // namespace isopatch::iga
