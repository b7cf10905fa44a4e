#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/post/elasticity_results.hpp"
#include "iga/post/stress_peaks.hpp"
#include "iga/spaces/discretization.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/processes.hpp"

namespace isopatch::iga {

/// Nodal forces, energy and largest values of the stresses of a displacement field.
struct InternalForces {
  Eigen::Matrix3Xd
      forces;  ///< K u per node before any coupling, (3, nodes), N; from the stresses, not from a matrix
  double energy = 0;            ///< half the integral of stress : elastic strain, J
  double thermal_work = 0;      ///< minus half the integral of stress : thermal strain, J
  Extremum max_von_mises;       ///< over the Gauss points that are not left out, Pa
  Extremum max_strain;          ///< Frobenius norm, over the same points
  LeftOut left_out;             ///< Gauss points where the map is folded
  StressPeaks peaks;            ///< over the points that are not
  UnresolvedEnergy unresolved;  ///< of the highest modes
};

/// Integrates the stresses of a displacement field.
/// @param displacement  coefficients per node, (3, nodes), m
/// @param points        Gauss points per element and direction; 0: as many as each map needs
/// @param thermal       strains that cause no stress, one per patch; empty: none
/// @throws Error fold_over  a Gauss point with det J <= 0, naming patch, parameter (the input's names) and
/// place
/// @cost  O((degree + 1)^4) per element, in parallel; the same for any number of threads
InternalForces internal_forces(const Discretization& discretization, const std::vector<Material>& materials,
                               const Eigen::Matrix3Xd& displacement, int points = 0,
                               const Progress& progress = {});

/// The same over the elements of some parts: forces and energy are additive. Without elements, a value of -1
/// in no patch.
InternalForces internal_forces(const Discretization& discretization, const std::vector<Material>& materials,
                               const Eigen::Matrix3Xd& displacement, const std::vector<PatchLayers>& parts,
                               int points = 0, const Progress& progress = {},
                               const std::vector<ThermalStrain>& thermal = {});

/// A displacement and the strains that cause no stress beside it.
struct StrainedPart {
  const Eigen::Matrix3Xd& displacement;       ///< as `internal_forces` takes it
  const std::vector<ThermalStrain>& thermal;  ///< one per patch; empty: none
};

/// The same of several displacements, for which the geometry at the points is computed once.
std::vector<InternalForces> internal_forces(const Discretization& discretization,
                                            const std::vector<Material>& materials,
                                            const std::vector<StrainedPart>& displacements,
                                            const std::vector<PatchLayers>& parts, int points = 0,
                                            const Progress& progress = {});

/// The forces per node that hold thermal strains back where nothing moves, turned round: what they load the
/// part with. (3, nodes), N
Eigen::Matrix3Xd thermal_forces(const Discretization& discretization, const std::vector<Material>& materials,
                                const std::vector<ThermalStrain>& thermal,
                                const std::vector<PatchLayers>& parts, int points = 0);

/// Combines the shares of all processes; all get the result.
InternalForces summed(InternalForces share, const solvers::Processes& processes);

}  // namespace isopatch::iga
