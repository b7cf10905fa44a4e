#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

Part pillow_block();
Part pilot_flange();
Part radial_bushing();
Part bent_bracket();
Part yoke();
Part timing_pulley();
Part valve_body();
Part clamp_collar();
Part webbed_lever();
Part mounting_rail();

}  // namespace isopatch::parts
