#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

Part motor_mount();
Part angle_bracket();
Part split_housing();
Part bell_crank();
Part weld_neck_flange();
Part gear_blank();
Part hydraulic_block();
Part rod_end();
Part vee_block();
Part vise_jaw();
Part cap_screw();
Part spindle();
Part u_channel();
Part lid();
Part eye_bolt();
Part swing_plate();

}  // namespace isopatch::parts
