#include "segmentation/profiles/quadrangulation_options.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {

namespace {

void in_range(const char* field, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("quadrangulation options: {} is {}, allowed is {} to {}", field, value, low, high));
}

}  // namespace

void validate(const QuadrangulationOptions& options) {
  in_range("smallest_angle", options.smallest_angle.degrees(), 1, 60);
  in_range("largest_angle", options.largest_angle.degrees(), 120, 175);
  in_range("largest_turn", options.largest_turn.degrees(), 60, 180);
  in_range("smallest_jacobian", options.smallest_jacobian, 0, 0.5);
  in_range("good_jacobian", options.good_jacobian, 0.05, 0.6);
  in_range("angle_weight", options.angle_weight, 0, 1e6);
  in_range("turn_weight", options.turn_weight, 0, 1e6);
  in_range("length_weight", options.length_weight, 0, 1e6);
  in_range("aspect_weight", options.aspect_weight, 0, 1e6);
  in_range("slant_weight", options.slant_weight, 0, 1e6);
  in_range("effort", options.effort, 0, 1e9);
}

}  // namespace isopatch::segmentation
