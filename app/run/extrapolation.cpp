#include "app/run/extrapolation.hpp"

#include <cmath>

namespace isopatch::app {
namespace {

// Changes that shrink by less than this from level to level are not taken for those of a converging sequence.
constexpr double least_shrinking = 0.9;

}  // namespace

bool is_settled(double value, double before) {
  return std::abs(value - before) < 1e-8 * std::abs(value);
}

std::optional<double> extrapolated(const std::vector<double>& values) {
  const std::size_t n = values.size();
  if (n < 3) return std::nullopt;
  const double before = values[n - 2] - values[n - 3];
  const double last = values[n - 1] - values[n - 2];
  const double shrinks = last / before;
  if (!(shrinks > 0 && shrinks < least_shrinking) || is_settled(values[n - 1], values[n - 2]))
    return std::nullopt;
  return values[n - 1] + last * shrinks / (1 - shrinks);
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
