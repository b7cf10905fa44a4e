#pragma once

#include "iga/material/material.hpp"
#include "verification/suites/exact_solution.hpp"

namespace isopatch::verification {

/// A thick-walled cylinder about z under inner pressure, plane strain.
/// @param inner, outer  radii, m
/// @source Lame; Timoshenko, Goodier, Theory of Elasticity, section 28
ExactSolution pressed_cylinder(const iga::Material& material, double pressure, double inner, double outer);

/// An infinite plate with a round hole of radius 1 about z, pulled along x, plane strain.
/// @param tension  far from the hole, Pa
/// @source Kirsch 1898; here from Muskhelishvili's potentials phi = S/4 (z + 2/z),
///         psi = -S/2 (z + 1/z - 1/z^3)
ExactSolution pulled_plate_with_hole(const iga::Material& material, double tension);

/// An infinite body with a spherical cavity of radius 1 about the origin, pulled along z.
/// @param tension  far from the cavity, Pa
/// @source Goodier, Concentration of stress around spherical and cylindrical inclusions and flaws, J. Appl.
///         Mech. 1933
ExactSolution pulled_body_with_cavity(const iga::Material& material, double tension);

}  // namespace isopatch::verification
