#pragma once

#include "app/base/internal/json_values.hpp"
#include "app/problem/cut_solids.hpp"

namespace isopatch::app {

/// How a body became hexahedra: its name, "hexahedra", what the report of its decomposition says, and the
/// "error" of one that was given up.
Json body_json(const CutBody& body);

}  // namespace isopatch::app
