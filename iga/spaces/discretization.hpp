#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "iga/spaces/discretization_options.hpp"
#include "iga/spaces/gauss_points.hpp"

namespace isopatch::iga {

/// The solution space: every patch of the model in a finer space (so the geometry stays exact), matching
/// across all interfaces. Its basis functions, all patches one after the other, are the *nodes*.
struct Discretization {
  geometry::MultiPatch model;
  std::vector<geometry::NurbsVolume> patches;  ///< the model's patches in the solution space
  std::vector<int> first_node;                 ///< of each patch, and the number of nodes at the end
  std::vector<GaussPoints> gauss_points;       ///< of each patch, as many as its map needs

  int node_count() const { return first_node.back(); }
  int patch_count() const { return static_cast<int>(patches.size()); }
  /// Gauss points in a patch if `asked` for so many in all directions, or with 0 for what its map needs.
  GaussPoints points_of(int patch, int asked) const {
    return asked > 0 ? GaussPoints{asked, asked, asked} : gauss_points[static_cast<std::size_t>(patch)];
  }
  /// Elements (nonempty knot spans) summed over the patches.
  std::int64_t element_count() const;
};

/// Builds the solution space. Where neighbours differ in degree or knots, both get the union, and so on from
/// patch to patch until all traces match; but for what `options` does not let spread, which makes interfaces
/// non-matching ones of `model`.
///
/// @throws Error invalid_argument  options out of range
/// @throws Error not_conforming    an interface whose weights are not proportional, or whose knots cannot be
/// matched
/// @cost   O(nodes * degree) per direction
Discretization discretize(const geometry::MultiPatch& model, const DiscretizationOptions& options = {});

}  // namespace isopatch::iga
