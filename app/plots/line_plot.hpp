#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/plots/plot_axis.hpp"

namespace isopatch::app {

/// A line of a plot. Points with a coordinate that is not finite, or not positive on a logarithmic axis, are
/// left out, and the line is broken there.
struct PlotSeries {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;  ///< as many as x
  bool markers = true;    ///< of long series some points only have one
  bool dashed = false;
  /// For orders of convergence, with two logarithmic axes: a triangle with this slope appears beside the
  /// last two points, and their measured slope beside it in the legend.
  std::optional<double> expected_slope = {};
};

/// A horizontal line with a label, for example a tolerance.
struct PlotLevel {
  std::string label;
  double value = 0;
};

/// Lines over one pair of axes.
struct LinePlot {
  std::string title;
  std::string description;  ///< what the picture shows, one sentence, for those who cannot see it
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotSeries> series;
  std::vector<PlotLevel> levels = {};
};

/// The slope d log y / d log x between the last two points that can be drawn; nothing with fewer than two.
std::optional<double> measured_slope(const PlotSeries& series);

/// A self-contained SVG picture as wide as its surroundings allow. Colours are CSS variables with fallbacks
/// that suit white paper; README.md lists them.
///
/// Any data give a picture: empty ones an empty frame.
/// @throws Error invalid_argument  a series with different numbers of x and y, naming it
std::string to_svg(const LinePlot& plot);

}  // namespace isopatch::app
