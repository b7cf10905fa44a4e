#pragma once

#include <Eigen/Core>

#include "iga/post/stress_points.hpp"

namespace isopatch::iga {

/// Largest values of measures of stress and where they are; in no patch where none was looked at.
struct StressPeaks {
  Extremum tension;      ///< the largest principal stress, Pa
  Extremum compression;  ///< minus the smallest principal stress, Pa
  Extremum tresca;       ///< largest minus smallest principal stress of a point, Pa
  Extremum utilization;  ///< von Mises stress over yield stress; in no patch without a yield stress
};

/// The larger ones of two.
StressPeaks together(const StressPeaks& a, const StressPeaks& b);
/// The largest over all processes; all get them.
StressPeaks largest(const StressPeaks& peaks, const solvers::Processes& processes);

/// A point of a search, with its stress.
struct StressPoint {
  const Eigen::Matrix3d& stress;
  double von_mises;
  double yield;  ///< of the material, Pa; 0 if it has none
};

/// Which peaks a point is above.
struct HigherPeaks {
  bool tension = false, compression = false, tresca = false, utilization = false;
  Eigen::Vector3d principal;  ///< only if one of the first three is
  bool any() const { return tension || compression || tresca || utilization; }
};

/// Compares a point with what was found so far. Principal stresses are computed only where bounds by the mean
/// and the von Mises stress allow a new largest one.
/// @source  eigenvalues of a deviator are at most 2/3 of its von Mises stress, their range at most 2/sqrt(3)
HigherPeaks higher_peaks(const StressPoint& point, const StressPeaks& so_far);

/// Takes a point into the peaks if it is above those that a search has seen.
/// @param place_of  gives the point as an Extremum without a value; called only for a new peak
/// @param seen      by the same thread, in this element and in those before it: a point that is not above
///                  cannot be the largest of all
template <class PlaceOf>
void take(const StressPoint& point, const PlaceOf& place_of, StressPeaks& seen, StressPeaks& peaks) {
  const HigherPeaks higher = higher_peaks(point, seen);
  if (!higher.any()) return;
  Extremum here = place_of();
  const auto set_both = [&](bool is_higher, double value, Extremum& seen_peak, Extremum& peak) {
    if (!is_higher) return;
    here.value = value;
    seen_peak = peak = here;
  };
  set_both(higher.tension, higher.principal[0], seen.tension, peaks.tension);
  set_both(higher.compression, -higher.principal[2], seen.compression, peaks.compression);
  set_both(higher.tresca, higher.principal[0] - higher.principal[2], seen.tresca, peaks.tresca);
  set_both(higher.utilization, point.von_mises / point.yield, seen.utilization, peaks.utilization);
}

}  // namespace isopatch::iga
