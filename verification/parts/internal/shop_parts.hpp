#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

Part bearing_block();
Part clevis();
Part hinge_leaf();
Part pulley();
Part t_slot_nut();
Part cam();
Part motor_plate();
Part manifold_block();
Part lever();
Part key_shaft();
Part heat_sink();
Part u_bracket();

}  // namespace isopatch::parts
