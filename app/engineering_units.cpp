#include "app/engineering_units.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace isopatch::app {
namespace {

struct Prefix {
  double factor;
  const char* symbol;
};
constexpr std::array<Prefix, 7> prefixes = {
    {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}}};

int power_of(std::string_view unit) {
  return unit.ends_with("^2") ? 2 : unit.ends_with("^3") ? 3 : 1;
}

/// The largest prefix that leaves at least 1 before the decimal point; lengths stop at m, areas and volumes
/// at mm.
Prefix suitable(double value, std::string_view unit) {
  const double magnitude = std::abs(value);
  const int power = power_of(unit);
  if (!(magnitude > 0) || !std::isfinite(magnitude)) return {1, ""};
  for (const Prefix& prefix : prefixes) {
    if (unit.starts_with('m') && prefix.factor > 1) continue;
    if (power > 1 && prefix.factor < 1e-3) continue;
    const double factor = std::pow(prefix.factor, power);
    // 0.1 m reads better as 100 mm; machine parts come in millimetres.
    const double least = unit == "m" && prefix.factor == 1 ? 10 : 1;
    if (magnitude >= least * factor) return {factor, prefix.symbol};
  }
  return power > 1 ? Prefix{std::pow(1e-3, power), "m"} : prefixes.back();
}

}  // namespace

std::string with_unit(double value, std::string_view unit) {
  if (value == 0) return fmt::format("0 {}", unit);
  const Prefix prefix = suitable(value, unit);
  return fmt::format("{:.4g} {}{}", value / prefix.factor, prefix.symbol, unit);
}

std::string place_with_unit(const Eigen::Vector3d& place, double model_size) {
  const bool metres = model_size >= 10;
  const double factor = metres ? 1 : 1e-3;
  // Digits to a hundred thousandth of the model's size; adding 0 turns -0 into 0.
  const double step = std::pow(10, std::floor(std::log10(std::max(model_size, 1e-12))) - 4);
  const auto digits = [&](double x) {
    return fmt::format("{:.6g}", std::round(x / step) * step / factor + 0.0);
  };
  return fmt::format("({}, {}, {}) {}", digits(place[0]), digits(place[1]), digits(place[2]),
                     metres ? "m" : "mm");
}

std::string vector_with_unit(const Eigen::Vector3d& vector, std::string_view unit) {
  const double largest = vector.cwiseAbs().maxCoeff();
  const Prefix prefix = suitable(largest, unit);
  const auto digits = [&](double x) {
    return fmt::format("{:.4g}", std::abs(x) < 1e-7 * largest ? 0.0 : x / prefix.factor);
  };
  return fmt::format("({}, {}, {}) {}{}", digits(vector[0]), digits(vector[1]), digits(vector[2]),
                     prefix.symbol, unit);
}

std::string with_separators(std::int64_t count) {
  std::string digits = fmt::format("{}", count);
  for (int i = static_cast<int>(digits.size()) - 3; i > (count < 0 ? 1 : 0); i -= 3)
    digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

std::string bytes_text(std::int64_t bytes) {
  const auto value = static_cast<double>(bytes);
  if (value >= 1e9) return fmt::format("{:.3g} GB", value / 1e9);
  if (value >= 1e6) return fmt::format("{:.3g} MB", value / 1e6);
  return fmt::format("{:.3g} kB", value / 1e3);
}

std::string seconds_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.2f} s", seconds);
  return fmt::format("{} min {} s", static_cast<int>(seconds) / 60, static_cast<int>(seconds) % 60);
}

}  // namespace isopatch::app
