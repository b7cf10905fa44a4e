#include "app/plots/axis_ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace isopatch::app {
namespace {

constexpr double round_off = 1e-9;  // of a step: a tick at the very end of a range is inside
constexpr const char* minus = "\u2212";

std::string raised(int exponent) {
  static constexpr std::array<std::string_view, 10> digits = {
      "\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074", "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "\u207b" : "";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += digits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string with_separators(const std::string& digits) {
  const std::size_t point = std::min(digits.find('.'), digits.size());
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && i < point && (point - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string fixed(double value, int decimals) {
  const std::string digits = with_separators(fmt::format("{:.{}f}", std::abs(value), decimals));
  const bool is_zero = digits.find_first_not_of("0.,") == std::string::npos;
  return (value < 0 && !is_zero ? minus : "") + digits;
}

// Writes the ticks of one axis alike: with the decimals of their step, very large and very small ones times a
// power of ten.
class TickText {
 public:
  TickText(double largest, double step) {
    const int exponent = static_cast<int>(std::floor(std::log10(largest) + round_off));
    if (exponent >= 7 || exponent < -4) exponent_ = exponent;
    decimals_ = std::max(0, exponent_ + static_cast<int>(std::ceil(-std::log10(step) - round_off)));
  }
  std::string operator()(double value) const {
    const std::string digits = fixed(value * std::pow(10., -exponent_), decimals_);
    return exponent_ == 0 || value == 0 ? digits : digits + "\u00d710" + raised(exponent_);
  }

 private:
  int exponent_ = 0;
  int decimals_ = 0;
};

// 10^exponent, or factor times it.
std::string power_text(int factor, int exponent) {
  if (exponent >= -3 && exponent <= 5) return fixed(factor * std::pow(10., exponent), std::max(0, -exponent));
  return (factor == 1 ? "" : fmt::format("{}\u00d7", factor)) + "10" + raised(exponent);
}

bool is_power_of_ten_labelled(int exponent, int every) {
  return (exponent % every + every) % every == 0;
}

}  // namespace

double tick_step(double range, int most, bool whole_numbers) {
  const double least = range / std::max(1, most - 1);
  const double power = std::pow(10., std::floor(std::log10(least)));
  double step = 10 * power;
  for (const double factor : {5., 2., 1.})
    if (factor * power >= least * (1 - round_off)) step = factor * power;
  return whole_numbers ? std::max(1., step) : step;
}

std::vector<Tick> linear_ticks(double low, double high, int most, bool whole_numbers) {
  const double step = tick_step(high - low, most, whole_numbers);
  const TickText text(std::max(std::abs(low), std::abs(high)), step);
  std::vector<Tick> ticks;
  for (double i = std::ceil(low / step - round_off); i <= high / step + round_off; ++i) {
    const double value = i == 0 ? 0 : i * step;  // no negative zero
    ticks.push_back({value, text(value)});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(double low, double high, int most) {
  if (high < 3 * low) return linear_ticks(low, high, most);
  const double first = std::log10(low) - round_off;
  const double last = std::log10(high) + round_off;
  const int powers = static_cast<int>(std::floor(last) - std::ceil(first)) + 1;
  const int every = std::max(1, (powers + most - 1) / most);
  const bool label_between = powers < 2;
  const bool mark_between = last - first <= 8;
  std::vector<Tick> ticks;
  for (int exponent = static_cast<int>(std::floor(first)); exponent <= static_cast<int>(std::floor(last));
       ++exponent) {
    for (int factor = 1; factor <= (mark_between ? 9 : 1); ++factor) {
      const double place = exponent + std::log10(factor);
      if (place < first || place > last) continue;
      const bool labelled = factor == 1 ? is_power_of_ten_labelled(exponent, every)
                                        : label_between && (factor == 2 || factor == 5);
      ticks.push_back({factor * std::pow(10., exponent), labelled ? power_text(factor, exponent) : ""});
    }
  }
  return ticks;
}

std::string number_text(double value) {
  if (!std::isfinite(value)) return "-";
  if (value == 0) return "0";
  // Rounded first: 9.999e5 has a power of ten more than it seems.
  const std::string digits = fmt::format("{:.2e}", value);
  const auto split = digits.find('e');
  const int exponent = std::stoi(digits.substr(split + 1));
  if (exponent >= 7 || exponent < -3) {
    std::string mantissa = fmt::format("{:g}", std::abs(std::stod(digits.substr(0, split))));
    return (value < 0 ? minus : "") + mantissa + "\u00d710" + raised(exponent);
  }
  std::string text = fixed(value, std::max(0, 2 - exponent));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

}  // namespace isopatch::app
