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

/// Divides what is to the left of one line, or of two at right angles, and mirrors it.
/// @param lines  about which the profile is symmetric; edges of it lie along them wherever they cross a
/// region
/// @throws Error unsupported  it is not so, or what `quadrangulate` throws
Quadrangulation mirrored_quadrangulation(const Profile& profile, const std::vector<MirrorLine>& lines,
                                         const QuadrangulationOptions& options = {});

}  // namespace isopatch::segmentation
