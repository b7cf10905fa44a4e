#pragma once

#include "app/study/study.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// The discretization of a study, with the patches that it names.
/// @throws Error invalid_argument  patches that do not exist, with their place
iga::DiscretizationOptions discretization_of(const Study& study, const geometry::MultiPatch& model);

}  // namespace isopatch::app
