#pragma once

#include <vector>

#include "segmentation/pieces/internal/piece.hpp"

namespace isopatch::segmentation {

/// Ways to cut a solid into stacks by planes, those with the fewest pieces first: a beam search that cuts the
/// piece that is least like a stack, and keeps the cuts after which the least is missing, none after which
/// more is.
/// @param cuts     that are made first
/// @param seconds  of the processor, after which no further plane is tried
/// @throws Error invalid_argument  one of them does not cut it
/// @return  all that take the fewest cuts; empty where none was found
/// @cost  100 cuts at most
std::vector<std::vector<Piece>> ways_to_cut(const geometry::Brep& solid,
                                            const std::vector<geometry::PlaneSurface>& cuts, double seconds);

/// The same with one piece cut by one more plane, wherever nothing is missing after that.
std::vector<std::vector<Piece>> cut_once_more(const std::vector<Piece>& pieces);

}  // namespace isopatch::segmentation
