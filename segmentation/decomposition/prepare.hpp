#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// A solid as one cell whose neighbouring faces are merged where they lie in one plane and have the same name
/// and colour, if the graph is 3-connected then: a triangulated box has six sides again. The merged face is
/// the lowest of them; vertices that are left on straight edges are gone. A graph that is not 3-connected
/// either way gets artificial edges, if they make it so.
/// @throws Error as `geometry::one_cell`
geometry::CellComplex prepared(const geometry::Brep& source);

/// Faces that became one in a complex that `prepared` gave or that was cut out of it: groups of two or more,
/// the face that is left of each first.
std::vector<std::vector<FaceId>> faces_made_one(const geometry::Brep& source,
                                                const geometry::CellComplex& made);

}  // namespace isopatch::segmentation
