#pragma once

#include <string>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "iga/result_file.hpp"

namespace isopatch::app {

/// The model of stored results, and how its input named faces and parameters.
struct StoredModel {
  geometry::MultiPatch model;
  std::vector<bool> was_left_handed;  ///< per patch: whether its first direction was turned around when read

  /// "3:north", in the input's naming.
  std::string label(geometry::PatchFace face) const;
  /// Between the input's parameters and those of the stored patches; its own inverse.
  geometry::Parameter<3> renamed(int patch, geometry::Parameter<3> parameter) const;
};

/// Per patch, whether the summary says that it was turned around when it was read.
std::vector<bool> left_handed_patches(const std::string& summary, std::size_t patches);

/// Finds again how stored patches meet, with the gaps that the summary says they had.
/// @param summary  text of summary.json; without one, nothing was turned around and gaps are the usual ones
/// @throws Error as `connect` does
StoredModel stored_model(const std::vector<geometry::NurbsVolume>& patches, const std::string& summary);

}  // namespace isopatch::app
