#include "app/run/extrapolation.hpp"

#include <algorithm>
#include <cmath>

namespace isopatch::app {
namespace {

// Changes that shrink by less than this from level to level are not taken for those of a converging sequence.
constexpr double least_shrinking = 0.9;
// The energy at a crack, the sharpest of all edges, shrinks by this: slower shrinking is that of meshes which
// are too coarse for it, and would go on for longer than it does.
constexpr double slowest = 0.5;

// The limit of the first so many values.
std::optional<double> limit_of(const std::vector<double>& values, std::size_t n) {
  if (n < 3) return std::nullopt;
  const double before = values[n - 2] - values[n - 3];
  const double last = values[n - 1] - values[n - 2];
  const double shrinks = last / before;
  if (!(shrinks > 0 && shrinks < least_shrinking) || is_settled(values[n - 1], values[n - 2]))
    return std::nullopt;
  const double most = std::min(shrinks, slowest);
  return values[n - 1] + last * most / (1 - most);
}

}  // namespace

bool is_settled(double value, double before) {
  return std::abs(value - before) < 1e-8 * std::abs(value);
}

std::optional<Extrapolation> extrapolated(const std::vector<double>& values) {
  const std::size_t n = values.size();
  const std::optional<double> limit = limit_of(values, n);
  if (!limit) return std::nullopt;
  const std::optional<double> before = limit_of(values, n - 1);
  return Extrapolation{*limit, std::abs(*limit - (before ? *before : values.back()))};
}

bool grows(const std::vector<double>& values) {
  // Below this share of the value a change says nothing of where it leads.
  constexpr double least_change = 0.02;
  const std::size_t n = values.size();
  if (n < 3) return false;
  const double before = values[n - 2] - values[n - 3];
  const double last = values[n - 1] - values[n - 2];
  return before > 0 && last >= least_shrinking * before && last > least_change * values[n - 1];
}

}  // namespace isopatch::app
