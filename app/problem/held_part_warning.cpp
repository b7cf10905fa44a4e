#include "app/problem/held_part_warning.hpp"

#include <fmt/format.h>

#include <variant>

#include "app/base/engineering_units.hpp"
#include "iga/problem/held_area.hpp"

namespace isopatch::app {

std::vector<Warning> held_part_warnings(const iga::ElasticityProblem& problem) {
  std::vector<Warning> warnings;
  for (const iga::Support& support : problem.supports) {
    if (support.faces.empty() || support.region.is_everywhere() ||
        std::holds_alternative<iga::ElasticSupport>(support.condition))
      continue;
    const iga::HeldArea area = held_area(problem.discretization.patches, support);
    if (area.has_element || area.held == 0) continue;  // what holds nothing is refused
    warnings.push_back(
        {fmt::format("{}: the part that it holds is narrower than the elements there, so its rim is not met: "
                     "what is held is worth {} instead of {}; refine, or divide the patch at the rim",
                     support.name, with_unit(area.held, "m^2"), with_unit(area.asked, "m^2"))});
  }
  return warnings;
}

}  // namespace isopatch::app
