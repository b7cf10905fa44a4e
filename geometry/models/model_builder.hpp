#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// Collects patches and, as they come, the names of their outer sides.
class ModelBuilder {
 public:
  /// @param names  sides that belong to named boundaries; a boundary appears in the order of its first face
  void add(NurbsVolume patch, const std::vector<std::pair<Side, std::string_view>>& names);

  const PatchSet& patches() const { return patches_; }

 private:
  PatchSet patches_;
};

}  // namespace isopatch::geometry
