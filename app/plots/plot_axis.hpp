#pragma once

#include <string>
#include <vector>

namespace isopatch::app {

enum class Scale { linear, logarithmic };

/// One axis of a plot.
struct PlotAxis {
  std::string label;  ///< "time"
  std::string unit;   ///< "s"; empty for counts and ratios
  Scale scale = Scale::linear;
  bool whole_numbers = false;        ///< ticks at whole numbers only
  std::vector<double> include = {};  ///< values that the axis shows whatever the data are
};

}  // namespace isopatch::app
