#pragma once

#include <string>
#include <vector>

#include "app/plots/plot_axis.hpp"

namespace isopatch::app {

/// One bar: a value for each part.
struct PlotBar {
  std::string name;
  std::vector<double> values;  ///< as many as the plot's parts; what is not positive and finite has no length
};

/// Horizontal bars, each made of the same parts one after the other, for example time per phase of several
/// runs.
struct BarPlot {
  std::string title;
  std::string description;  ///< what the picture shows, one sentence, for those who cannot see it
  std::string label;        ///< of the value axis: "time"
  std::string unit;         ///< "s"
  std::vector<std::string> parts;
  std::vector<PlotBar> bars;
};

/// A self-contained SVG picture in the look of `to_svg(LinePlot)`.
/// @throws Error invalid_argument  a bar with a wrong number of values, naming it
std::string to_svg(const BarPlot& plot);

}  // namespace isopatch::app
