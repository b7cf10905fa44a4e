#include "app/pictures/value_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isopatch::app {
namespace {

/// Of a step: so far may values lie outside of a round range.
constexpr double left_out = 0.02;

struct Piece {
  double value;
  double area;
};

/// The value below which a share of the area lies.
double quantile(const std::vector<Piece>& sorted, double total, double share) {
  double below = 0;
  for (const Piece& piece : sorted) {
    below += piece.area;
    if (below >= share * total) return piece.value;
  }
  return sorted.back().value;
}

/// 1, 2 or 5 times a power of ten: an eighth of the range or somewhat more.
double round_step(double range) {
  const double least = range / 8;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double leading : {1.0, 2.0, 5.0})
    if (leading * power >= least * (1 - 1e-9)) return leading * power;
  return 10 * power;
}

/// A range without length gets one, so that it has a scale.
ValueRange with_length(ValueRange range) {
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (range.high - range.low > 1e-9 * size) return range;
  if (size == 0) return {0, 1};
  return {range.low - 0.1 * size, range.high + 0.1 * size};
}

/// @param range  in the ticks' unit
std::vector<Tick> ticks(const ValueRange& range, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  std::vector<Tick> result;
  for (double n = std::ceil(range.low / step - 1e-6); n <= range.high / step + 1e-6; ++n) {
    const double value = n * step + 0.0;  // not -0
    const bool plain = largest < 1e5 && decimals <= 4;
    result.push_back({(value - range.low) / (range.high - range.low),
                      plain ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.4g}", value)});
  }
  return result;
}

}  // namespace

ValueRange full_range(const Surface& surface) {
  return {surface.values.minCoeff(), surface.values.maxCoeff()};
}

ValueRange range_of_area(const Surface& surface, double percent) {
  if (percent >= 100) return full_range(surface);
  std::vector<Piece> pieces;
  double total = 0;
  for (const auto& triangle : surface.triangles) {
    const double area = area_vector(surface, triangle).norm();
    const double sum =
        surface.values[triangle[0]] + surface.values[triangle[1]] + surface.values[triangle[2]];
    pieces.push_back({sum / 3, area});
    total += area;
  }
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.value < b.value; });
  const double tail = (1 - percent / 100) / 2;
  return {quantile(pieces, total, tail), quantile(pieces, total, 1 - tail)};
}

ValueScale round_scale(const ValueRange& range, double unit) {
  const ValueRange wide = with_length(range);
  const ValueRange in_unit = {wide.low / unit, wide.high / unit};
  const double step = round_step(in_unit.high - in_unit.low);
  const ValueRange round = {step * std::floor(in_unit.low / step + left_out),
                            step * std::ceil(in_unit.high / step - left_out)};
  return {{round.low * unit, round.high * unit}, ticks(round, step)};
}

ValueScale exact_scale(const ValueRange& range, double unit) {
  const ValueRange in_unit = {range.low / unit, range.high / unit};
  return {range, ticks(in_unit, round_step(in_unit.high - in_unit.low))};
}

Eigen::VectorXd scaled(const Eigen::VectorXd& values, const ValueRange& range) {
  return ((values.array() - range.low) / (range.high - range.low)).cwiseMax(0.0).cwiseMin(1.0);
}

}  // namespace isopatch::app
