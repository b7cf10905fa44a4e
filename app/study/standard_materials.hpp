#pragma once

#include <string>
#include <vector>

#include "iga/material/material.hpp"

namespace isopatch::app {

/// A material by name: usual handbook values at room temperature, good for a first look. Give your own for
/// design.
struct StandardMaterial {
  std::string name;
  double young;    ///< Pa
  double poisson;  ///< pure number
  double density;  ///< kg/m^3
};

/// steel, stainless_steel, cast_iron, aluminium, titanium, copper, brass, magnesium, abs, pa6, peek,
/// concrete, glass
const std::vector<StandardMaterial>& standard_materials();

}  // namespace isopatch::app
