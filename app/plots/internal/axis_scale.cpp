#include "app/plots/internal/axis_scale.hpp"

#include <algorithm>
#include <cmath>

namespace isopatch::app {
namespace {

constexpr double largest = 1e200;
constexpr int most_ticks = 7;

struct Range {
  double low = 0;
  double high = 0;
};

// Ends at ticks.
Range linear_range(Range values, bool whole_numbers) {
  const double size = std::max(std::abs(values.low), std::abs(values.high));
  if (values.high - values.low <= 1e-9 * size) values = {std::min(0., values.low), std::max(0., values.high)};
  if (values.high - values.low < 1 / largest) values = {0, 1};
  const double step = tick_step(values.high - values.low, most_ticks, whole_numbers);
  return {step * std::floor(values.low / step + 1e-9), step * std::ceil(values.high / step - 1e-9)};
}

// Logarithms, with some room at both ends.
Range logarithmic_range(Range values) {
  const Range logarithms = {std::log10(values.low), std::log10(values.high)};
  const double room = std::max(0.05, 0.04 * (logarithms.high - logarithms.low));
  return {logarithms.low - room, logarithms.high + room};
}

}  // namespace

bool has_place(double value, Scale scale) {
  return std::isfinite(value) && std::abs(value) <= largest &&
         (scale == Scale::linear || value >= 1 / largest);
}

AxisScale::AxisScale(const PlotAxis& axis, std::vector<double> values, double begin, double end)
    : scale_(axis.scale), begin_(begin), end_(end) {
  values.insert(values.end(), axis.include.begin(), axis.include.end());
  std::erase_if(values, [&](double value) { return !has_place(value, scale_); });
  if (values.empty()) values = {1};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const Range range = scale_ == Scale::linear ? linear_range({*low, *high}, axis.whole_numbers)
                                              : logarithmic_range({*low, *high});
  low_ = range.low;
  high_ = range.high;
  ticks_ = scale_ == Scale::linear ? linear_ticks(low_, high_, most_ticks, axis.whole_numbers)
                                   : logarithmic_ticks(std::pow(10., low_), std::pow(10., high_), most_ticks);
}

double AxisScale::transformed(double value) const {
  return scale_ == Scale::linear ? value : std::log10(value);
}

double AxisScale::place(double value) const {
  return begin_ + (transformed(value) - low_) * density();
}

AxisScale AxisScale::between(double begin, double end) const {
  AxisScale result = *this;
  result.begin_ = begin;
  result.end_ = end;
  return result;
}

std::string axis_text(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : label + " (" + unit + ")";
}

}  // namespace isopatch::app
