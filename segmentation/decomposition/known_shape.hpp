#pragma once

#include <optional>
#include <string>

#include "geometry/brep/brep.hpp"
#include "segmentation/decomposition/decomposition.hpp"
#include "segmentation/decomposition/decomposition_options.hpp"

namespace isopatch::segmentation {

/// What is known of a solid without a search.
struct KnownShape {
  /// Of a solid whose hexahedra follow from what it is: one that is swept or turned, with branches or in
  /// pieces, whatever its graph; of several ways the cheapest.
  std::optional<Decomposition> decomposition;
  /// Where it looks like one, a sentence: what stopped it, or what is in the way and what to do.
  std::string why_not;
};

/// Recognizes solids whose hexahedra follow from their shape: swept, turned, with branches, in pieces.
///
/// @return  nothing where only cuts are asked for. Where T-joints are kept, layers of a stack and pieces
///          between planes are divided each by itself
/// @throws Error invalid_argument  cuts or a symmetry that the solid does not have
/// @throws Error unsupported  given cuts of which no pieces come that can be swept
KnownShape known_shape(const geometry::Brep& solid, const DecompositionOptions& options);

}  // namespace isopatch::segmentation
