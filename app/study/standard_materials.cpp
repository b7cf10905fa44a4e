#include "app/study/standard_materials.hpp"

namespace isopatch::app {

const std::vector<StandardMaterial>& standard_materials() {
  static const std::vector<StandardMaterial> materials = {
      {"steel", 210e9, 0.30, 7850},     {"stainless_steel", 193e9, 0.30, 8000},
      {"cast_iron", 110e9, 0.28, 7200}, {"aluminium", 70e9, 0.33, 2700},
      {"titanium", 114e9, 0.34, 4430},  {"copper", 120e9, 0.34, 8960},
      {"brass", 105e9, 0.34, 8500},     {"magnesium", 45e9, 0.29, 1800},
      {"abs", 2.3e9, 0.37, 1050},       {"pa6", 2.7e9, 0.39, 1140},
      {"peek", 3.7e9, 0.39, 1300},      {"concrete", 30e9, 0.20, 2400},
      {"glass", 70e9, 0.22, 2500},
  };
  return materials;
}

}  // namespace isopatch::app
