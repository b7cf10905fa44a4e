#include "app/run/run_level.hpp"

#include <algorithm>

namespace isopatch::app {

bool is_even(const std::vector<RunLevel>& levels) {
  return std::none_of(levels.begin(), levels.end(), [](const RunLevel& level) { return level.is_adaptive; });
}

}  // namespace isopatch::app
