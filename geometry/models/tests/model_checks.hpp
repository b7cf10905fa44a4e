#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// What round-off may add to a volume or an area of size 1: about 10 points^3 sums of terms exact to 1e-16.
inline constexpr double round_off = 1e-13;

/// What the Gauss rules may miss on the rational maps here, relative. Measured: at most 3e-14, on arcs of 120
/// degrees.
inline constexpr double quadrature_error = 1e-12;

/// The faces of a named boundary; none, and a failed test, if the model has no such name.
std::vector<PatchFace> faces_of(const MultiPatch& model, const std::string& name);

double boundary_area(const MultiPatch& model, const std::string& name);
double surface_area(const MultiPatch& model);
double total_volume(const MultiPatch& model);

/// Largest |residual(point)| on a grid of 7 x 7 points on every face of a named boundary.
double worst(const MultiPatch& model, const std::string& name,
             const std::function<double(const Eigen::Vector3d&)>& residual);

struct Expected {
  int patches = 1;
  int interfaces = 0;
  int boundary_faces = 6;
};

/// Connects the patches and checks what every generated model promises: one body, the expected counts, all
/// interfaces stated, every boundary face in exactly one named boundary, certified Jacobians, and on the two
/// sides of every interface equal control points and weights with one common factor.
MultiPatch expect_sound(const PatchSet& patches, const Expected& expected);

/// Checks that `make` throws Error invalid_argument with a message that contains every one of `parts`.
void expect_refused(const std::function<void()>& make, const std::vector<std::string>& parts);

}  // namespace isopatch::geometry
