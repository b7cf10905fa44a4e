#include "geometry/io/coordinate_grain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isopatch::geometry {

void CoordinateGrain::add(std::string_view word, double value) {
  int digits = 0;
  bool leading = true;
  for (const char c : word) {
    if (c == 'e' || c == 'E') break;
    if (c < '0' || c > '9') continue;
    leading = leading && c == '0';
    digits += !leading;
  }
  digits_ = std::max(digits_, digits);
  largest_ = std::max(largest_, std::abs(value));
}

double CoordinateGrain::step() const {
  if (!(largest_ > 0)) return 0;
  constexpr int fewest_digits = 5;  // programs round to six; round numbers are what they are
  if (digits_ < fewest_digits) return largest_ * std::numeric_limits<double>::epsilon();
  const double by_digits = std::pow(10.0, std::floor(std::log10(largest_)) + 1 - digits_);
  return std::max(by_digits, largest_ * std::numeric_limits<double>::epsilon());
}

double float_step(double value) {
  return std::abs(value) * static_cast<double>(std::numeric_limits<float>::epsilon());
}

}  // namespace isopatch::geometry
