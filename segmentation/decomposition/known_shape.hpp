#pragma once

#include <optional>
#include <string>

#include "geometry/brep/brep.hpp"
#include "segmentation/decomposition/decomposition.hpp"
#include "segmentation/decomposition/decomposition_options.hpp"

namespace isopatch::segmentation {

/// What is known of a solid without a search.
struct KnownShape {
  /// Of a solid whose hexahedra follow from what it is: one that is swept, whatever its graph.
  std::optional<Decomposition> decomposition;
  std::string why_not;   ///< where it looks like one and could not be divided, what stopped it
  std::string no_stack;  ///< where it does not, what keeps it from being one
};

/// Nothing where only cuts are asked for, or T-joints, which such solids do not have.
KnownShape known_shape(const geometry::Brep& solid, const DecompositionOptions& options);

}  // namespace isopatch::segmentation
