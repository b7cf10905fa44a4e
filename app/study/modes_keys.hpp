#pragma once

#include "app/study/keys.hpp"
#include "app/study/modes_input.hpp"

namespace isopatch::app {

const Keys<ModesInput>& modes_keys();

}  // namespace isopatch::app
