#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/brep/solid_error.hpp"
#include "segmentation/decomposition/decomposition_options.hpp"

namespace isopatch::segmentation {

/// What `decompose` has before it, as far as that is known without searching.
struct Prospect {
  int sides = 0;  ///< plane neighbours of one name and colour count as one
  std::vector<EdgeId>
      concave;                ///< edges of the solid with more than 180 degrees inside: cuts go through them
  std::vector<EdgeId> blunt;  ///< likewise those with about as much: tangent, nearly flat
  std::string seen_as =
      {};  ///< see `looks`; of what comes in pieces, and would not be cut, as in `DecompositionReport`
  std::optional<geometry::SolidError> refusal = {};  ///< why it will not be tried; all else is empty then
};

/// Whether a patch can follow a topological hexahedron at all its corners: no side has a corner of 180
/// degrees or more, none points inwards. Otherwise it has to be cut there.
bool corners_open(const geometry::Brep& hexahedron);

/// @cost  that of one triangulation and of the angles at all edges; only what looks like nothing that is
/// known, and would not be cut, is divided
Prospect prospect(const geometry::Brep& solid, const DecompositionOptions& options = {});

}  // namespace isopatch::segmentation
