#pragma once

#include <vector>

#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// The elements of a patch between two neighbouring knots of one direction.
struct ElementLayer {
  int patch = 0;
  int direction = 0;  ///< 0 .. 2
  int span = 0;       ///< of the direction's elements, from 0
  bool operator==(const ElementLayer&) const = default;
};

/// All elements that one more knot cuts: a layer of a patch and those that continue it in other patches,
/// since faces of neighbours have the same knots.
using ElementSheet = std::vector<ElementLayer>;

/// The sheets of a discretization: every layer is in exactly one.
/// @param spread  as `DiscretizationOptions` has it; without it every layer is a sheet of its own
/// @cost  nearly O(layers)
std::vector<ElementSheet> element_sheets(const Discretization& discretization, bool spread = true);

}  // namespace isopatch::iga
