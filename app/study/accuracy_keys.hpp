#pragma once

#include "app/study/accuracy_input.hpp"
#include "app/study/keys.hpp"

namespace isopatch::app {

const Keys<AccuracyInput>& accuracy_keys();

}  // namespace isopatch::app
