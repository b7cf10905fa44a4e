#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

Part ball_stud();
Part turned_handle();
Part rounded_shaft();
Part rounded_washer();
Part bent_pipe();
Part bent_bar();
Part shell_octant();

}  // namespace isopatch::parts
