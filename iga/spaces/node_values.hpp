#pragma once

#include <vector>

#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// A function of a patch and its value somewhere.
struct NodeValue {
  int node = 0;  ///< index in the patch
  double value = 0;
};

/// The functions that are not 0 at a parameter of a patch; their values add up to 1.
/// @param parameter  clamped into the patch
/// @cost  O((degree + 1)^3)
std::vector<NodeValue> node_values(const PatchSpace& space, const geometry::Parameter<3>& parameter);

}  // namespace isopatch::iga
