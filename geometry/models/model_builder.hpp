#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// Collects patches, how they meet and the names of their outer sides.
class ModelBuilder {
 public:
  /// @param names  sides that belong to named boundaries; a boundary appears in the order of its first face
  void add(NurbsVolume patch, const std::vector<std::pair<Side, std::string_view>>& names);

  /// States that two faces meet.
  void join(PatchFace first, PatchFace second, const FaceOrientation& orientation = {});
  /// Joins the patches first, first + step, ... one behind the other in a direction, with equal directions.
  /// @param closed  whether the last one meets the first
  void join_row(int first, int step, int count, int direction, bool closed = false);
  /// Joins all patches: a grid, the first direction running fastest.
  /// @param closed  by direction
  void join_grid(const std::array<int, 3>& counts, const std::array<bool, 3>& closed = {});

  const PatchSet& patches() const { return patches_; }

 private:
  PatchSet patches_;
};

}  // namespace isopatch::geometry
