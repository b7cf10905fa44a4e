#include "iga/problem/thermal_load.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::iga {

std::vector<ThermalStrain> thermal_strains(const std::vector<TemperatureLoad>& loads,
                                           const std::vector<Material>& materials) {
  if (loads.empty()) return {};
  std::vector<ThermalStrain> result(materials.size());
  for (const TemperatureLoad& load : loads)
    for (const PatchId patch : load.patches) {
      if (patch.value < 0 || patch.value >= static_cast<int>(materials.size()))
        throw Error(ErrorCode::invalid_argument, fmt::format("'{}': there is no patch {}; the model has {}",
                                                             load.name, patch.value, materials.size()));
      const double expansion = materials[static_cast<std::size_t>(patch.value)].expansion;
      if (expansion == 0)
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("'{}': patch {} has no thermal expansion; a temperature needs one in its "
                                "material, such as expansion = \"12e-6 1/K\" for steel",
                                load.name, patch.value));
      const TemperatureChange& t = load.temperature;
      ThermalStrain& strain = result[static_cast<std::size_t>(patch.value)];
      strain.at_origin += expansion * (t.change - t.gradient.dot(t.point));
      strain.gradient += expansion * t.gradient;
    }
  return result;
}

}  // namespace isopatch::iga
