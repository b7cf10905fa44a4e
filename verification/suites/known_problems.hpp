#pragma once

#include "verification/suites/known_problem.hpp"

namespace isopatch::verification {

/// A wave whose forces follow from it, in `manufactured.cpp`: on one distorted patch, on eight in random
/// orientations, on a brick with a collapsed face, and on two rational patches.
KnownProblem one_patch(int degree);
KnownProblem eight_patches(int degree);
KnownProblem wedge();
KnownProblem manufactured_cylinder();

/// Closed forms, in `closed_form_orders.cpp`: Lame, Kirsch and Goodier.
KnownProblem pressed_tube();
KnownProblem plate_with_hole(const iga::Material& material);
KnownProblem body_with_cavity(const iga::Material& material);

}  // namespace isopatch::verification
