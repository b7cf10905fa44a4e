#pragma once

#include <string>
#include <vector>

namespace isopatch::app {

/// A mark on an axis.
struct Tick {
  double value = 0;
  std::string text;  ///< empty for a minor tick
};

/// Multiples of 1, 2 or 5 times a power of ten, inside the range.
/// @param low, high      finite, low < high
/// @param most           labels at most, at least 2
/// @param whole_numbers  whether the step must be a whole number
std::vector<Tick> linear_ticks(double low, double high, int most = 7, bool whole_numbers = false);

/// Powers of ten, every n-th if there are many; with fewer than two in the range also 2 and 5 times these.
/// Between them minor ticks at their multiples. A range with high < 3 low has linear ticks.
/// @param low, high  finite, 0 < low < high
std::vector<Tick> logarithmic_ticks(double low, double high, int most = 7);

/// The distance of linear ticks: the smallest 1, 2 or 5 times a power of ten with at most `most` in `range`.
double tick_step(double range, int most, bool whole_numbers = false);

/// A number for people, three digits: "1,230", "0.0457", "3.2e-7" as 3.2 times a raised power of ten.
std::string number_text(double value);

}  // namespace isopatch::app
