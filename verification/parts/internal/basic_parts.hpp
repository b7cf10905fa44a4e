#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

Part bored_block();
Part plate_with_2_bores();
Part plate_with_3_bores();
Part plate_with_5_bores();
Part countersunk_plate();
Part chamfered_block();
Part rounded_block();
Part bracket();
Part link();
Part nut();
Part chamfered_nut();
Part round_bar();
Part stepped_shaft();
Part shaft_with_boss();
Part flange();
Part pipe_elbow();
Part pipe_tee();

}  // namespace isopatch::parts
