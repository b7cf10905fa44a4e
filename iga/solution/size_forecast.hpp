#pragma once

#include <cstdint>
#include <vector>

#include "iga/coupling/coupling_kind.hpp"
#include "iga/distribution/distribution.hpp"
#include "iga/material/material.hpp"
#include "iga/spaces/matching_spaces.hpp"
#include "solvers/factor_forecast.hpp"

namespace isopatch::iga {

/// Forecast of a problem's unknowns, memory and factor from the knots of its solution space: nothing of it
/// need exist yet.
///
/// Bytes are those of the process with most of them.
struct SizeForecast {
  std::int64_t nodes = 0;     ///< of all patches
  std::int64_t unknowns = 0;  ///< of the whole system, multipliers included
  int degree = 0;             ///< highest
  Coupling coupling = Coupling::elimination;
  bool has_mortar = false;  ///< multipliers between faces that do not match
  int processes = 1;
  int right_sides = 1;                    ///< load cases that one set-up serves
  bool is_nearly_incompressible = false;  ///< one of the materials: iterations grow
  solvers::FactorForecast factor;         ///< of the whole system
  double geometry_bytes = 0;              ///< control points of the solution space, while they are made
  double nodal_bytes = 0;                 ///< global nodes, frames, loads and results
  double matrix_bytes = 0;
  double system_bytes = 0;     ///< vectors and numberings beside the matrix
  double multigrid_bytes = 0;  ///< iterations with the multigrid, without a matrix

  bool has_multipliers() const { return coupling == Coupling::lagrange || has_mortar; }
};

/// Forecasts what a problem will need.
/// @param knots  of the solution space (`solution_knots`, or those of a discretization)
/// @cost  at most some tenths of a second, whatever the size: nodes are counted in groups
SizeForecast forecast_size(const geometry::MultiPatch& model, const DirectionKnots& knots,
                           const std::vector<Material>& materials, Coupling coupling, int processes,
                           NonMatchingCoupling non_matching = NonMatchingCoupling::nitsche);
/// The same of a discretization that exists.
SizeForecast forecast_size(const Discretization& discretization, const std::vector<Material>& materials,
                           Coupling coupling, int processes,
                           NonMatchingCoupling non_matching = NonMatchingCoupling::nitsche);

}  // namespace isopatch::iga
