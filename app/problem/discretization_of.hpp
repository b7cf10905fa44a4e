#pragma once

#include <vector>

#include "app/base/warning.hpp"
#include "app/study/study.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// The discretization of a study, with the patches that it names.
/// @throws Error invalid_argument  patches that do not exist, or a part that none reaches into, with their
/// place
iga::DiscretizationOptions discretization_of(const Study& study, const geometry::MultiPatch& model);

/// One warning for each key of a [[discretization.patch]] that asks for less than [discretization] gives all
/// patches, and so changes nothing.
std::vector<Warning> idle_refinement_warnings(const Study& study);

}  // namespace isopatch::app
