#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "geometry/brep/part21.hpp"

namespace isopatch::geometry {

/// What a STEP file says of its unit of length.
struct StepUnits {
  bool stated = false;                ///< some shape has a unit of length; the others count as millimetres
  std::string name;                   ///< "mm", "inch", "mm and m"; "" where none is stated
  std::vector<std::string> warnings;  ///< what is missing, cannot be resolved or contradicts itself
  /// Instances to be said otherwise, because kernels do not follow units that are made of other units.
  std::map<std::int64_t, std::string> replaced;
  std::string added;  ///< instances that these need
};

/// Follows the units of all shapes of a file, through chains of conversions, down to the metre.
StepUnits step_units(const Part21File& file);

}  // namespace isopatch::geometry
