#pragma once

#include "segmentation/profiles/internal/start.hpp"

namespace isopatch::segmentation::planar {

/// Where curves may well be cut: where their normals point in multiples of 15 degrees to the longest line, at
/// equal shares of their length, and across from vertices and centres nearby.
CutPlaces candidates_of(const Profile& profile, const std::vector<Curve>& curves);

/// Where the tangent of a curve turns through a direction and those a step apart from it, in radians.
std::vector<double> places_of_directions(const Curve& curve, double direction, double step);

}  // namespace isopatch::segmentation::planar
