#pragma once

#include <string>

#include "geometry/base/progress.hpp"
#include "geometry/brep/brep.hpp"
#include "segmentation/decomposition/decomposition.hpp"
#include "segmentation/decomposition/decomposition_options.hpp"

namespace isopatch::segmentation {

/// Takes a solid apart into topological hexahedra that meet side to side, by cutting loops.
///
/// Cuts go through concave edges first. Every cell becomes a hexahedron, a prism or a tetrahedron; cuts that
/// divide a side are carried on through its neighbours, then templates make hexahedra of all. Where T-joints
/// are kept, hexahedra stay as they are cut, and templates divide the others alone.
/// @param name  of the solid, for messages
/// @throws Error not_contractible     holes lead through it
/// @throws Error not_three_connected  the graph of its sides is not 3-connected: names the pair
/// @throws CuttingError unsupported  no way was found: says what stopped it, with what was cut by then
/// @param progress  told after every round of the search, phase and details with a tab between them:
///                  "cutting 'part'\t3 cuts, 2 parts unfinished, 4 of 60 s"
Decomposition decompose(const geometry::Brep& solid, const std::string& name,
                        const DecompositionOptions& options = {}, const Progress& progress = {});

}  // namespace isopatch::segmentation
