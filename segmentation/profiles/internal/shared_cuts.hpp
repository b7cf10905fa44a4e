#pragma once

#include <vector>

#include "segmentation/profiles/internal/start.hpp"

namespace isopatch::segmentation::planar {

/// Of each edge: whether there are wanted regions on both its sides.
std::vector<bool> shared_edges(const Profile& profile);

/// How shared edges, whose cuts two regions must agree on, are cut at the start.
struct SharedCuts {
  bool diagonal = false;  ///< closed curves between the axes instead of on them
};

/// Cuts of shared edges, so few that sides turn little and each region can have an even number of corners.
/// @return places on shared edges; none on others
CutPlaces shared_places(const Profile& profile, const std::vector<Curve>& curves, const SharedCuts& cuts);

/// With more cuts, so that each region can have an even number of corners.
CutPlaces made_even(const Profile& profile, const std::vector<Curve>& curves, CutPlaces places);

/// More cuts on the shared edges of regions that could not be divided: opposite their bores and the cuts of
/// their other edges, else opposite corners that point into them, or, where there is nothing of that kind,
/// one more on the longest.
CutPlaces further_places(const Profile& profile, const std::vector<Curve>& curves, const CutPlaces& places,
                         const std::vector<int>& regions);

}  // namespace isopatch::segmentation::planar
