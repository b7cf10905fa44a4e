#pragma once

#include <string>
#include <vector>

#include "iga/material/material.hpp"

namespace isopatch::app {

/// A material by name, at room temperature. Families ("steel") have usual handbook values, good for a first
/// look, and no yield stress, which depends on the grade; grades ("S355") have the least yield stress of
/// their standard.
struct StandardMaterial {
  std::string name;
  double young;        ///< Pa
  double poisson;      ///< pure number
  double density;      ///< kg/m^3
  double expansion;    ///< linear thermal, 1/K; of steels and alloys the mean between 20 and 100 C
  double yield;        ///< Pa; 0 for families and brittle materials
  std::string source;  ///< of all values
};

const std::vector<StandardMaterial>& standard_materials();

}  // namespace isopatch::app
