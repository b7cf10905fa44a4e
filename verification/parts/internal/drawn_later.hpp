#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

Part gusset_bracket();
Part valve_block();
Part shaft_end();
Part hex_bolt();
Part split_clamp();
Part cover_plate();

}  // namespace isopatch::parts
