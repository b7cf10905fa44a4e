#pragma once

#include <vector>

#include "iga/assembly/surface_stiffness.hpp"
#include "iga/material/thermal_strain.hpp"

namespace isopatch::iga {

/// What thermal strains do to Nitsche's terms: the tractions there are those of stresses, of which thermal
/// strains cause none, so for displacements v the loads have
///
///     - integral (sigma_t n) . [v],   sigma_t = (3 lambda + 2 mu) strain I
///
/// of the traction's side as well. Shares of all processes add up.
/// @param parts   what this process integrates
/// @param strain  one per patch
/// @return  per node of all patches, (3, nodes), N
/// @cost    that of the common refinement of the faces
Eigen::Matrix3Xd interface_thermal_load(const std::vector<PatchSpace>& spaces,
                                        const std::vector<PatchLayers>& parts, const SurfaceTerms& terms,
                                        const std::vector<ThermalStrain>& strain);

}  // namespace isopatch::iga
