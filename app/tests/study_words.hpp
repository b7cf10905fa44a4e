#pragma once

#include <string>

#include "app/study/study.hpp"

namespace isopatch::app {

/// All that a study says, a line for each value: "solver.tolerance 1e-09", "support 0 wall symmetry 0 0 0".
/// Of a generated model also what the patches are: "patches 8", "extent 2 1 1", "from 0 0 0", "volume 2".
std::string words_of(const Study& study);

}  // namespace isopatch::app
