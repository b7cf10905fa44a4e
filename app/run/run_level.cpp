#include "app/run/run_level.hpp"

#include <algorithm>

namespace isopatch::app {

std::vector<RunLevel> levels_of_case(std::vector<RunLevel> levels, std::size_t index) {
  for (RunLevel& level : levels) {
    if (index >= level.cases.size()) continue;
    const CaseLevel& own = level.cases[index];
    level.internal_energy = own.internal_energy;
    level.max_displacement = own.max_displacement;
    level.max_von_mises = own.max_von_mises;
    level.error = own.error;
  }
  return levels;
}

bool is_even(const std::vector<RunLevel>& levels) {
  return std::none_of(levels.begin(), levels.end(), [](const RunLevel& level) { return level.is_adaptive; });
}

}  // namespace isopatch::app
