#pragma once

#include <compare>
#include <functional>
#include <string>

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

namespace isopatch::segmentation {

struct CodeOptions {
  bool mirror_images_are_equal = true;
  bool edge_kinds = false;  ///< whether kinds of edges count
};

/// What two cells have in common iff they are the same up to numbering.
struct CanonicalCode {
  std::u16string letters;
  auto operator<=>(const CanonicalCode&) const = default;
};

/// Of a connected planar map: codes of two maps are equal iff the maps are isomorphic.
/// @throws Error not_manifold  see CellIncidence;  unsupported  65,000 vertices or more
/// @cost  O(E^2) at worst, much less where degrees and faces differ
CanonicalCode canonical_code(const CellGraph& graph, const CodeOptions& options = {});

}  // namespace isopatch::segmentation

template <>
struct std::hash<isopatch::segmentation::CanonicalCode> {
  std::size_t operator()(const isopatch::segmentation::CanonicalCode& code) const noexcept {
    return std::hash<std::u16string>()(code.letters);
  }
};
