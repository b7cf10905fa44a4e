#pragma once

#include <vector>

#include "iga/post/stress_points.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// The largest von Mises stress on faces of patches, where it usually is and where no Gauss point lies.
struct FaceStresses {
  Extremum max_von_mises;  ///< Pa; a value of -1 in no patch if there is no point
  LeftOut left_out;        ///< points where the map is folded or collapsed
};

/// On a grid of 2 degree + 1 points per element and direction, ends included, of all six faces of the
/// patches.
/// @param parts  whose elements are looked at
/// @throws Error singular_system  a stress that is no finite number
/// @cost  O(degree^4) per element at a face
FaceStresses stresses_on_faces(const ElasticField& field, const std::vector<PatchLayers>& parts);
/// Of all patches.
FaceStresses stresses_on_faces(const ElasticField& field);

/// The shares of all processes together, on all of them.
FaceStresses summed(const FaceStresses& share, const solvers::Processes& processes);

}  // namespace isopatch::iga
