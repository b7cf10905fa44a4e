#pragma once

#include <string>
#include <vector>

#include "app/render/part_picture.hpp"
#include "app/solids/describe_solid.hpp"

namespace isopatch::app {

/// Composes the picture of solids: faces in their own colours or in light ones by turns, edges by convexity;
/// of one alone also the visible vertices with their numbers.
/// @param solids  at least one
/// @param title   for the caption, if none is given
/// @throws Error invalid_argument  a field that solids do not have; a cut that leaves nothing
PartPicture solids_picture(const std::vector<SolidReport>& solids, const PictureOptions& options,
                           const std::string& title);

/// The planar drawing of a solid's edge graph as SVG: edges by convexity, vertices and faces numbered as in
/// `info`.
/// @throws Error not_three_connected  with what stands in the way
std::string solid_graph_svg(const SolidReport& solid, const std::string& title);

}  // namespace isopatch::app
