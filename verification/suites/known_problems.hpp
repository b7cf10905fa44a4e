#pragma once

#include "verification/suites/known_problem.hpp"
#include "verification/suites/wave.hpp"

namespace isopatch::verification {

/// A wave, made linear on the named boundaries, which are planes, and prescribed there, with tractions on all
/// other faces of any model.
KnownProblem manufactured(const std::string& name, const geometry::MultiPatch& model,
                          const std::vector<std::string>& held, Wave wave = {});

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
