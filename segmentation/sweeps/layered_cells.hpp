#pragma once

#include <optional>

#include "geometry/brep/brep.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/sweeps/swept_columns.hpp"

namespace isopatch::segmentation {

/// Divides a stack layer by layer: what lies between two floors next to each other in height has a drawing of
/// its own, without the outlines of floors elsewhere. Hexahedra of one layer meet side to side, those of two
/// in parts of their sides (T-joints). A side that is a part of a floor and a part of none has the floor's
/// name. Of several directions the one with the fewest hexahedra is taken.
/// @return  nothing for a solid that is no stack of two layers or more
/// @throws Error unsupported  as `swept_cells`; outlines of a layer that touch in a point
std::optional<SweptCells> layered_cells(const geometry::Brep& solid,
                                        const QuadrangulationOptions& options = {.thorough = true});

}  // namespace isopatch::segmentation
