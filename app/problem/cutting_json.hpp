#pragma once

#include <string>

#include "app/problem/cut_solids.hpp"

namespace isopatch::app {

/// How solids became hexahedra, as JSON: "bodies", each with its name, "hexahedra" and what the report of its
/// decomposition says, and "warnings".
std::string cutting_json_text(const CutSolids& solids);

}  // namespace isopatch::app
