#include "app/plots/bar_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plots/internal/axis_scale.hpp"
#include "app/plots/internal/legend.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

constexpr double plot_width = 640;
constexpr double bars_end = plot_width - 90;  // room for the sums
constexpr double thickness = 24;
constexpr double pitch = 36;
constexpr double widest_name = 200;

double length(double value) {
  return has_place(value, Scale::logarithmic) ? value : 0;
}

double sum(const PlotBar& bar) {
  double total = 0;
  for (const double value : bar.values) total += length(value);
  return total;
}

void check(const BarPlot& plot) {
  for (const PlotBar& bar : plot.bars)
    if (bar.values.size() != plot.parts.size())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("bar '{}' of the plot '{}' has {} values for {} parts", bar.name, plot.title,
                              bar.values.size(), plot.parts.size()));
}

std::string value_text(const BarPlot& plot, double value) {
  return number_text(value) + (plot.unit.empty() ? "" : " " + plot.unit);
}

// The numbers appear where they have room.
void draw_bar(Svg& svg, const BarPlot& plot, const PlotBar& bar, const AxisScale& axis, double top) {
  double before = 0;
  for (std::size_t i = 0; i < bar.values.size(); ++i) {
    const double value = length(bar.values[i]);
    if (value == 0) continue;
    const double begin = axis.place(before);
    const double end = axis.place(before + value);
    svg.rectangle({begin, top}, end - begin, thickness, "f" + colour_class(i),
                  fmt::format("{}, {}: {}", bar.name, plot.parts[i], value_text(plot, value)));
    if (text_width(number_text(value), text_size) + 8 < end - begin)
      svg.text({(begin + end) / 2, top + thickness / 2 + 4}, number_text(value), "v" + colour_class(i),
               Anchor::middle);
    before += value;
  }
  svg.text({axis.place(before) + 6, top + thickness / 2 + 4}, value_text(plot, before));
}

void draw_axis(Svg& svg, const BarPlot& plot, const AxisScale& axis, double left, double top, double bottom) {
  for (const Tick& tick : axis.ticks()) {
    const double at = axis.place(tick.value);
    svg.line({at, top}, {at, bottom}, "grid");
    svg.line({at, bottom}, {at, bottom + 5}, "axis");
    svg.text({at, bottom + 18}, tick.text, "text", Anchor::middle);
  }
  svg.polyline({{left, top}, {left, bottom}, {bars_end, bottom}}, "axis");
  svg.text({(left + bars_end) / 2, bottom + 36}, axis_text(plot.label, plot.unit), "text", Anchor::middle);
}

}  // namespace

std::string to_svg(const BarPlot& plot) {
  check(plot);
  std::vector<Legend::Entry> entries;
  for (const std::string& part : plot.parts) entries.push_back({part, Legend::Sample::area});
  const Legend names(entries, plot_width);
  std::vector<double> values;
  double left = 20;
  for (const PlotBar& bar : plot.bars) {
    values.push_back(sum(bar));
    left = std::max(left, 20 + std::min(widest_name, text_width(bar.name, text_size)));
  }
  const double top = names.bottom() + 10;
  const double bottom = top + pitch * std::max(1., static_cast<double>(plot.bars.size()));
  const AxisScale axis({.label = "", .unit = "", .include = {0}}, values, left, bars_end);
  Svg svg(plot_width, bottom + 46, plot.title, plot.description);
  draw_axis(svg, plot, axis, left, top, bottom);
  for (std::size_t i = 0; i < plot.bars.size(); ++i) {
    const double at = top + pitch * static_cast<double>(i) + (pitch - thickness) / 2;
    svg.text({left - 8, at + thickness / 2 + 4}, fitted(plot.bars[i].name, text_size, widest_name), "text",
             Anchor::end);
    draw_bar(svg, plot, plot.bars[i], axis, at);
  }
  names.draw(svg);
  return svg.finished();
}

}  // namespace isopatch::app
