#pragma once

#include <string>
#include <vector>

#include "app/plots/axis_ticks.hpp"
#include "app/plots/plot_axis.hpp"

namespace isopatch::app {

/// Whether a value has a place on such an axis: finite, of a sane size, positive on a logarithmic one.
bool has_place(double value, Scale scale);

/// Where the values of an axis lie in the picture.
class AxisScale {
 public:
  /// @param values      that the axis must show; those without a place are passed over
  /// @param begin, end  coordinates of its low and high end
  AxisScale(const PlotAxis& axis, std::vector<double> values, double begin, double end);

  double place(double value) const;
  /// Coordinates per unit, or per power of ten.
  double density() const { return (end_ - begin_) / (high_ - low_); }
  /// The same axis between other coordinates.
  AxisScale between(double begin, double end) const;

  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  double transformed(double value) const;

  Scale scale_;
  double low_ = 0;  // of the transformed values
  double high_ = 1;
  double begin_;
  double end_;
  std::vector<Tick> ticks_;
};

/// "time (s)".
std::string axis_text(const std::string& label, const std::string& unit);

}  // namespace isopatch::app
