#pragma once

#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"

namespace isopatch::segmentation {

/// A line that a drawing may be symmetric about.
struct MirrorLine {
  Eigen::Vector2d point, along;  ///< m, unit
};

/// Lines about which all edges of a profile are symmetric, eight at most; those along its axes come first.
/// @throws Error bad_format  the profile is invalid (see `validate`)
/// @cost  the square of the number of edges for each direction that is tried, some 20
std::vector<MirrorLine> mirror_lines(const Profile& profile);

/// @cost  the square of the number of edges
bool is_symmetric(const Profile& profile, const MirrorLine& line);

/// Sets of lines about which a drawing can be put together from a part: the wedge between two that are next
/// to each other of three or more at equal angles, a quarter, a half; by the size of the part.
/// @param lines  all about which it is symmetric
std::vector<std::vector<MirrorLine>> ways_to_mirror(const std::vector<MirrorLine>& lines);

/// What lines become when they are mirrored about each other: these have to be drawn.
/// @throws Error unsupported  lines that do not meet at a whole part of 180 degrees
std::vector<MirrorLine> all_images(const std::vector<MirrorLine>& lines);

/// Where only what is to the left of all lines is wanted.
/// @throws Error unsupported  the lines are not drawn where they cross a region
Profile part_to_mirror(Profile profile, const std::vector<MirrorLine>& lines);

/// The whole, put together from the quadrilaterals of that part.
/// @throws Error unsupported  the profile is not symmetric
Quadrangulation mirrored(const Profile& profile, const std::vector<MirrorLine>& lines, Quadrangulation part);

/// With chords for all that lies on the lines, which nothing bounds there.
Quadrangulation without_lines(const Profile& profile, const std::vector<MirrorLine>& lines,
                              Quadrangulation quads);

/// Divides what is to the left of some lines, and mirrors it.
/// @param lines  one, or two that meet at a whole part of 180 degrees, about which the profile is symmetric;
/// edges of it lie along all their images wherever these cross a region
/// @throws Error unsupported  it is not so, or what `quadrangulate` throws
Quadrangulation mirrored_quadrangulation(const Profile& profile, const std::vector<MirrorLine>& lines,
                                         const QuadrangulationOptions& options = {});

}  // namespace isopatch::segmentation
