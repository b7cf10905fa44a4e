#pragma once

#include <vector>

#include "iga/post/stress_peaks.hpp"
#include "iga/post/stress_points.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// The largest von Mises stress on faces of patches, where it usually is and where no Gauss point lies.
struct FaceStresses {
  Extremum max_von_mises;  ///< Pa; a value of -1 in no patch if there is no point
  LeftOut left_out;        ///< points where the map is folded or collapsed
  StressPeaks peaks = {};  ///< over the same points
};

/// Evaluates stresses on all six faces of patches, on a grid of 2 degree + 1 points per element and
/// direction, ends included.
/// @param parts  element layers whose faces are evaluated
/// @throws Error singular_system  a stress that is no finite number
/// @cost  O(degree^4) per element at a face
FaceStresses stresses_on_faces(const ElasticField& field, const std::vector<PatchLayers>& parts);
/// The same of several fields on the same patches, whose geometry is evaluated once.
/// @param fields  not empty
std::vector<FaceStresses> stresses_on_faces(const std::vector<const ElasticField*>& fields,
                                            const std::vector<PatchLayers>& parts);
/// The same of all patches.
FaceStresses stresses_on_faces(const ElasticField& field);

/// Combines the shares of all processes; all get the result.
FaceStresses summed(const FaceStresses& share, const solvers::Processes& processes);

}  // namespace isopatch::iga
