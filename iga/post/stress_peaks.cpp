#include "iga/post/stress_peaks.hpp"

#include "iga/post/stress_measures.hpp"

namespace isopatch::iga {
namespace {

bool is_above(double value, const Extremum& peak) {
  return peak.patch < 0 || is_larger(value, peak.value);
}

}  // namespace

StressPeaks together(const StressPeaks& a, const StressPeaks& b) {
  return {larger(a.tension, b.tension), larger(a.compression, b.compression), larger(a.tresca, b.tresca),
          larger(a.utilization, b.utilization)};
}

StressPeaks largest(const StressPeaks& peaks, const solvers::Processes& processes) {
  return {largest(peaks.tension, processes), largest(peaks.compression, processes),
          largest(peaks.tresca, processes), largest(peaks.utilization, processes)};
}

HigherPeaks higher_peaks(const StressPoint& point, const StressPeaks& so_far) {
  constexpr double round_off = 1 + 1e-12;
  const double of_deviator = round_off * 2 / 3 * point.von_mises;
  const double range = round_off * 1.1547005383792517 * point.von_mises;  // 2 / sqrt(3)
  const double mean = point.stress.trace() / 3;
  HigherPeaks result;
  result.utilization = point.yield > 0 && is_above(point.von_mises / point.yield, so_far.utilization);
  if (!is_above(mean + of_deviator, so_far.tension) && !is_above(of_deviator - mean, so_far.compression) &&
      !is_above(range, so_far.tresca))
    return result;
  result.principal = principal_values(point.stress);
  result.tension = is_above(result.principal[0], so_far.tension);
  result.compression = is_above(-result.principal[2], so_far.compression);
  result.tresca = is_above(result.principal[0] - result.principal[2], so_far.tresca);
  return result;
}

}  // namespace isopatch::iga
