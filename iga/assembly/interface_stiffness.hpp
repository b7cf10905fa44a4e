#pragma once

#include <vector>

#include "iga/assembly/node_blocks.hpp"
#include "iga/coupling/interface_roles.hpp"
#include "iga/material/material.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// Nitsche's method on non-matching interfaces, as blocks beside the stiffness: for displacements u, v with
/// the jump [u] = u_traction - u_other and the outward normal n of the traction's side the integral of
///
///     - (sigma(u) n) . [v] - (sigma(v) n) . [u] + [u] . T [v].
///
/// T = 2 k c A, with A = mu I + (lambda + mu) n n^T of the traction's side and c the smallest number with
/// integral (sigma n) . A^-1 sigma n over an element's side <= c integral sigma : strain over the element; k
/// sides of the element are such. c is (degree + 1)^2 / thickness on elements that are bricks, the largest of
/// that over the side on others. So the whole stays positive definite and nothing is to be tuned.
///
/// @param spaces  of all patches, whose functions may be coarser than the geometry
/// @param same_point  how far faces may be apart, m
/// @return  empty where all interfaces match
/// @cost    by sum factorization where both sides have the same lines of equal parameters: a seventh of the
/// elements' on a link of 16^3 elements a patch of degree 3. Else (degree + 1)^5 per quadrature point, of
/// (degree + 3)^2 per cell of the common refinement, some ten times as much
/// @source  Nitsche 1971; Apostolatos, Schmidt, Wuechner, Bletzinger, A Nitsche-type formulation for domain
///          decomposition in isogeometric analysis, 2014; the constant by Warburton, Hesthaven 2003
NodeBlocks interface_stiffness(const std::vector<CoupledFaces>& interfaces,
                               const std::vector<PatchSpace>& spaces, const std::vector<Material>& materials,
                               double same_point);

}  // namespace isopatch::iga
