#pragma once

#include <string>
#include <vector>

namespace isopatch::segmentation::test {

/// STEP files in mm, written down entity by entity.
std::string step_cylinder(double radius, double height);
/// The half of one, cut along its axis: its ends have two corners.
std::string step_half_cylinder(double radius, double height);
/// A box of 4 x 4 x 1 with a square hole of 2 x 2 through it.
std::string step_square_ring();

}  // namespace isopatch::segmentation::test
