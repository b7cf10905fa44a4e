#pragma once

#include <string>
#include <vector>

#include "app/pictures/surface.hpp"

namespace isopatch::app {

struct ValueRange {
  double low = 0;
  double high = 0;
};

/// The range that holds `percent` of a surface's area between two equal tails; the whole range for 100. Peaks
/// at singular corners would otherwise take all colours for themselves.
/// @param percent  above 50, to 100
ValueRange range_of_area(const Surface& surface, double percent);

/// The smallest and the largest value at all.
ValueRange full_range(const Surface& surface);

struct Tick {
  double position = 0;  ///< 0 at the low, 1 at the high end
  std::string text;
};

/// What colours mean: the range from the first to the last colour, and round numbers on it.
struct ValueScale {
  ValueRange range;
  std::vector<Tick> ticks;
};

/// A range widened to round numbers, which are its ticks; five to ten of them. Up to a fiftieth of a step
/// may lie outside.
/// @param unit  what one unit of the ticks' numbers is worth: 1e6 for MPa
ValueScale round_scale(const ValueRange& range, double unit);

/// Just this range, with the round numbers that lie in it.
ValueScale exact_scale(const ValueRange& range, double unit);

/// Values to [0, 1] over a range; what lies outside goes to its ends.
Eigen::VectorXd scaled(const Eigen::VectorXd& values, const ValueRange& range);

}  // namespace isopatch::app
