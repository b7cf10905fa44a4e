#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/splines/knot_vector.hpp"
#include "segmentation/parameterization/deviation_grid.hpp"
#include "segmentation/parameterization/internal/face_map.hpp"
#include "segmentation/parameterization/internal/rational_net.hpp"

namespace isopatch::segmentation {

/// A face's net that its edges make by themselves, with its distances from the surface.
struct ExactFace {
  RationalNet net;
  DeviationGrid deviations;
};

/// The net that the edges of a face make by themselves, if it lies on the face's surface.
///
/// Tried are the blend of the edges in homogeneous coordinates (exact on planes, and between rulings of
/// cylinders, cones and extruded curves), and what comes of turning one edge along an arc (exact between
/// circles of latitude and meridians of whatever is a surface of revolution).
/// @param framed    the edges' control points on its boundary, the blend inside
/// @param at        parameters to look at
/// @param distance  from the surface that is good enough, model units
/// @return  nothing where none is that near
std::optional<ExactFace> exact_face(const FaceMap& map, const std::array<geometry::KnotVector, 2>& knots,
                                    const RationalNet& framed, const std::array<std::vector<double>, 2>& at,
                                    double distance);

}  // namespace isopatch::segmentation
