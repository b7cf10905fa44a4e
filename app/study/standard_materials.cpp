#include "app/study/standard_materials.hpp"

namespace isopatch::app {
namespace {

const std::string handbook = "usual handbook values";
const std::string structural =
    "yield: EN 10025-2, thickness up to 16 mm; E, nu, expansion: EN 1993-1-1, 3.2.6; density: EN 1991-1-1, "
    "A.4";
const std::string stainless =
    "yield: EN 10088-2, hot rolled plate; E, density, expansion: EN 10088-1; nu: EN 1993-1-4, 2.1.3";
const std::string aluminium_code = "EN 1999-1-1; yield: table 3.2; all else: 3.2.5";

}  // namespace

const std::vector<StandardMaterial>& standard_materials() {
  static const std::vector<StandardMaterial> materials = {
      {"steel", 210e9, 0.30, 7850, 12e-6, 0, handbook},
      {"stainless_steel", 193e9, 0.30, 8000, 17e-6, 0, handbook},
      {"cast_iron", 110e9, 0.28, 7200, 10.5e-6, 0, handbook},
      {"aluminium", 70e9, 0.33, 2700, 23e-6, 0, handbook},
      {"titanium", 114e9, 0.34, 4430, 8.6e-6, 0, handbook},
      {"copper", 120e9, 0.34, 8960, 17e-6, 0, handbook},
      {"brass", 105e9, 0.34, 8500, 20e-6, 0, handbook},
      {"magnesium", 45e9, 0.29, 1800, 26e-6, 0, handbook},
      {"abs", 2.3e9, 0.37, 1050, 90e-6, 0, handbook},
      {"pa6", 2.7e9, 0.39, 1140, 80e-6, 0, handbook},
      {"peek", 3.7e9, 0.39, 1300, 47e-6, 0, handbook},
      {"concrete", 30e9, 0.20, 2400, 10e-6, 0, handbook},
      {"glass", 70e9, 0.22, 2500, 9e-6, 0, handbook},
      {"S235", 210e9, 0.30, 7850, 12e-6, 235e6, structural},
      {"S275", 210e9, 0.30, 7850, 12e-6, 275e6, structural},
      {"S355", 210e9, 0.30, 7850, 12e-6, 355e6, structural},
      {"42CrMo4", 210e9, 0.30, 7850, 12e-6, 650e6,
       "yield: EN ISO 683-2, +QT, diameter 40 to 100 mm; all else: usual handbook values"},
      {"1.4301", 200e9, 0.30, 7900, 16e-6, 210e6, stainless},
      {"1.4404", 200e9, 0.30, 8000, 16e-6, 220e6, stainless},
      {"EN-GJS-400-15", 169e9, 0.275, 7100, 12.5e-6, 250e6, "EN 1563, wall up to 30 mm, and its annex"},
      {"5083-O", 70e9, 0.30, 2700, 23e-6, 125e6, aluminium_code},
      {"6060-T66", 70e9, 0.30, 2700, 23e-6, 150e6, aluminium_code},
      {"6082-T6", 70e9, 0.30, 2700, 23e-6, 240e6, aluminium_code},
      {"7075-T6", 71.7e9, 0.33, 2810, 23.6e-6, 503e6, "ASM handbook 2, typical"},
      {"Ti-6Al-4V", 113.8e9, 0.342, 4430, 8.6e-6, 828e6,
       "yield: ASTM B265, grade 5; all else: ASM handbook 2"},
  };
  return materials;
}

}  // namespace isopatch::app
