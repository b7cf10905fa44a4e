#pragma once

#include <cstdint>

#include "iga/coupling/coupling_kind.hpp"
#include "iga/spaces/matching_spaces.hpp"
#include "solvers/factor_forecast.hpp"

namespace isopatch::iga {

/// The stiffness matrix that a discretization will have, known from its knots alone.
struct PatternForecast {
  std::int64_t nodes = 0;        ///< of all patches
  std::int64_t rows = 0;         ///< blocks of three unknowns: global nodes, or nodes with multipliers
  std::int64_t multipliers = 0;  ///< rows of constraints, three a pair of nodes
  std::int64_t blocks = 0;    ///< stored: on and above the diagonal; exact but for collapsed edges and faces
  solvers::RowGroups groups;  ///< of neighbouring nodes, for the forecast of a factor
  double widening = 1;  ///< how much wider groups are than functions overlap, where there would be too many
};

/// Counts rows, blocks and the groups' graph of the matrix, whose nodes and values need not exist yet.
///
/// Nodes are taken together along each direction: the first and the last one by themselves, because
/// interfaces tie them, the others in groups about as wide as functions overlap, or wider where
/// there would be too many.
///
/// @param knots  of the solution space, with matching traces
/// @cost   O(groups); at most about `most_groups` of them, if there are not more patches than that
PatternForecast forecast_pattern(const geometry::MultiPatch& model, const DirectionKnots& knots,
                                 Coupling coupling, int most_groups = 20'000);

}  // namespace isopatch::iga
