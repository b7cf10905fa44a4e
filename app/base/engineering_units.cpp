#include "app/base/engineering_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/base/place_text.hpp"
#include "app/base/unit_prefixes.hpp"

namespace isopatch::app {
namespace {

struct Prefix {
  double factor = 1;
  std::string_view symbol = {};
};

/// What four digits round up to 1 is printed as 1 of the larger unit: areas and volumes that were integrated
/// are seldom exact.
constexpr double reads_as_one = 1 - 5e-5;

Prefix prefix_of(std::string_view symbol) {
  return {prefix_factor(symbol), symbol};
}

constexpr std::array<std::string_view, 7> prefixes = {"G", "M", "k", "", "m", "u", "n"};
/// Of m, for areas and volumes, with the centimetres that people use there.
constexpr std::array<std::string_view, 4> length_prefixes = {"", "c", "m", "u"};

Prefix suitable_power(double magnitude, int power) {
  Prefix found;
  for (const std::string_view symbol : length_prefixes) {
    found = {std::pow(prefix_factor(symbol), power), symbol};
    if (magnitude >= reads_as_one * found.factor) break;
  }
  return found;
}

/// The largest prefix that leaves at least 1 before the decimal point; lengths stop at m.
Prefix suitable(double value, std::string_view unit) {
  const double magnitude = std::abs(value);
  if (!(magnitude > 0) || !std::isfinite(magnitude)) return {};
  if (unit == "m^2") return suitable_power(magnitude, 2);
  if (unit == "m^3") return suitable_power(magnitude, 3);
  for (const std::string_view symbol : prefixes) {
    const Prefix prefix = prefix_of(symbol);
    const bool length = unit == "m";
    if (length && prefix.factor > 1) continue;
    // 0.1 m reads better as 100 mm; machine parts come in millimetres.
    const double least = length && prefix.factor == 1 ? 10 : reads_as_one;
    if (magnitude >= least * prefix.factor) return prefix;
  }
  return prefix_of(prefixes.back());
}

}  // namespace

DisplayUnit display_unit(double largest, std::string_view unit) {
  const Prefix prefix = suitable(largest, unit);
  return {fmt::format("{}{}", prefix.symbol, unit), 1 / prefix.factor};
}

DisplayUnit model_length_unit(double model_size) {
  return model_size >= 10 ? DisplayUnit{"m", 1} : DisplayUnit{"mm", 1e3};
}

std::string with_unit(double value, std::string_view unit) {
  if (value == 0) return fmt::format("0 {}", unit);
  const Prefix prefix = suitable(value, unit);
  return fmt::format("{:.4g} {}{}", value / prefix.factor, prefix.symbol, unit);
}

std::string with_uncertainty(double value, double uncertainty, std::string_view unit) {
  const ScaledUnit scaled = unit_for(std::max(std::abs(value), uncertainty), unit);
  const double error = uncertainty / scaled.factor;
  const double last_digit = error > 0 ? std::pow(10, std::floor(std::log10(error)) - 1) : 1;
  const int decimals = last_digit < 1 ? static_cast<int>(std::lround(-std::log10(last_digit))) : 0;
  return fmt::format("{:.4g} +- {:.{}f} {}", value / scaled.factor,
                     std::round(error / last_digit) * last_digit, decimals, scaled.symbol);
}

ScaledUnit unit_for(double value, std::string_view unit) {
  if (unit.empty()) return {};
  const Prefix prefix = suitable(value, unit);
  return {prefix.factor, fmt::format("{}{}", prefix.symbol, unit)};
}

std::string place_with_unit(const Eigen::Vector3d& place, double model_size) {
  const DisplayUnit unit = model_length_unit(model_size);
  // Digits to a hundred thousandth of the model's size; adding 0 turns -0 into 0.
  const double step = std::pow(10, std::floor(std::log10(std::max(model_size, 1e-12))) - 4);
  const auto digits = [&](double x) {
    return fmt::format("{:.6g}", std::round(x / step) * step * unit.factor + 0.0);
  };
  return fmt::format("{} {}", triple_text(digits(place[0]), digits(place[1]), digits(place[2])), unit.unit);
}

std::string vector_with_unit(const Eigen::Vector3d& vector, std::string_view unit) {
  const double largest = vector.cwiseAbs().maxCoeff();
  const Prefix prefix = suitable(largest, unit);
  const auto digits = [&](double x) {
    return fmt::format("{:.4g}", std::abs(x) < 1e-7 * largest ? 0.0 : x / prefix.factor);
  };
  return fmt::format("{} {}{}", triple_text(digits(vector[0]), digits(vector[1]), digits(vector[2])),
                     prefix.symbol, unit);
}

double without_round_off(double value, double scale) {
  return std::abs(value) < 1e-10 * scale ? 0.0 : value;
}

Eigen::Vector3d without_round_off(const Eigen::Vector3d& vector, double scale) {
  return vector.unaryExpr([&](double x) { return without_round_off(x, scale); });
}

std::string with_separators(std::int64_t count) {
  const std::string digits = fmt::format("{}", count);
  std::string result;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const bool after_digit = i > 0 && digits[i - 1] != '-';
    if (after_digit && (digits.size() - i) % 3 == 0) result += ',';
    result += digits[i];
  }
  return result;
}

std::string counted(std::int64_t count, std::string_view singular, std::string_view plural) {
  const bool regular = count == 1 || plural.empty();
  return fmt::format("{} {}{}", with_separators(count), regular ? singular : plural,
                     regular && count != 1 ? "s" : "");
}

std::string bytes_text(std::int64_t bytes) {
  const auto value = static_cast<double>(bytes);
  // What would be rounded to 1,000 of a unit is one of the next.
  if (value >= 999.5e6) return fmt::format("{:.3g} GB", value / 1e9);
  if (value >= 999.5e3) return fmt::format("{:.3g} MB", value / 1e6);
  return fmt::format("{:.3g} kB", value / 1e3);
}

std::string seconds_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.2f} s", seconds);
  return fmt::format("{} min {} s", static_cast<int>(seconds) / 60, static_cast<int>(seconds) % 60);
}

}  // namespace isopatch::app
