#pragma once

#include <optional>
#include <vector>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/internal/curve.hpp"
#include "segmentation/profiles/internal/divide_polygon.hpp"

namespace isopatch::segmentation::planar {

/// Places on each curve, increasing and inside (0, 1) or [0, 1) if closed, at which it may well be cut.
using CutPlaces = std::vector<std::vector<double>>;

/// Curves that have no places yet cut into pieces that turn by at most an angle (radians), lines into pieces
/// not much longer than they are far from others; curves cut more where outlines would meet as polygons.
/// @param fixed curves that get no more places but for the last reason
CutPlaces even_places(const std::vector<Curve>& curves, const std::vector<bool>& fixed, CutPlaces places,
                      double turn);

/// Triangles with cuts at the given places, one at least on each closed curve.
/// @throws Error unsupported naming a region whose loops cross or touch
CellMesh triangles_of(const Profile& profile, const std::vector<Curve>& curves, const CutPlaces& places);

/// The corners of a region: vertices and cuts, in the order of its loop.
struct RegionOutline {
  std::vector<Node> nodes;
  std::vector<Place> places;
};
/// @return nothing where there are holes or no corners
std::optional<RegionOutline> outline_of_region(const Profile& profile, const std::vector<Curve>& curves,
                                               const CutPlaces& places, int region);

}  // namespace isopatch::segmentation::planar
