#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace isopatch::segmentation {

/// A curve in space over [0, 1], measured, so that it can be run through by arc length.
class ArcLength {
 public:
  /// @param chords  how many measure the curve at least; the error of length and of `parameter` falls with
  /// their square. They are doubled while half as many make the length differ by a thousandth, up to 16 times
  /// as many: curves that wind need them.
  explicit ArcLength(const std::function<Eigen::Vector3d(double)>& curve, int chords = 300);

  double length() const { return at_.back(); }
  /// How far the curve turns on its way, rad; 0 for a line.
  double turning() const { return turning_; }
  /// The parameter where a share of the length lies behind; smooth between the chords (monotone cubics).
  /// @source Fritsch, Carlson 1980; slopes as the harmonic means of Fritsch, Butland 1984
  double parameter(double share) const;

 private:
  std::vector<double> at_;      ///< length up to parameter i / chords
  std::vector<double> slopes_;  ///< of parameter over length there
  double turning_ = 0;
};

}  // namespace isopatch::segmentation
