#include "app/plots/line_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plots/internal/axis_scale.hpp"
#include "app/plots/internal/legend.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

constexpr double line_plot_width = 640;
constexpr double lines_end = line_plot_width - 26;
constexpr double area_height = 300;
constexpr double axis_height = 46;
constexpr std::size_t markers_of_long_series = 12;
constexpr std::size_t short_series = 40;

void check(const LinePlot& plot) {
  for (const PlotSeries& series : plot.series)
    if (series.x.size() != series.y.size())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("series '{}' of the plot '{}' has {} values of x and {} of y", series.name,
                              plot.title, series.x.size(), series.y.size()));
}

// Where a line plot's points lie in the picture.
struct PlotArea {
  const LinePlot& plot;
  AxisScale x;
  AxisScale y;
  double left = 0;
  double top = 0;
  double bottom = 0;

  bool shows(const PlotSeries& series, std::size_t i) const {
    return has_place(series.x[i], plot.x.scale) && has_place(series.y[i], plot.y.scale);
  }
  SvgPoint place(const PlotSeries& series, std::size_t i) const {
    return {x.place(series.x[i]), y.place(series.y[i])};
  }
};

PlotArea plot_area(const LinePlot& plot, double top) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const PlotLevel& level : plot.levels) ys.push_back(level.value);
  for (const PlotSeries& series : plot.series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!has_place(series.x[i], plot.x.scale) || !has_place(series.y[i], plot.y.scale)) continue;
      xs.push_back(series.x[i]);
      ys.push_back(series.y[i]);
    }
  }
  const double bottom = top + area_height;
  const AxisScale y(plot.y, ys, bottom, top);
  double widest = 0;
  for (const Tick& tick : y.ticks()) widest = std::max(widest, text_width(tick.text, text_size));
  const double left = 38 + widest;
  return {plot, AxisScale(plot.x, xs, left, lines_end), y, left, top, bottom};
}

void draw_axes(Svg& svg, const PlotArea& area) {
  const double bottom = area.bottom;
  for (const Tick& tick : area.x.ticks()) {
    const double at = area.x.place(tick.value);
    const bool minor = tick.text.empty();
    if (!minor) svg.line({at, area.top}, {at, bottom}, "grid");
    svg.line({at, bottom}, {at, bottom + (minor ? 3 : 5)}, "axis");
    if (!minor) svg.text({at, bottom + 18}, tick.text, "text", Anchor::middle);
  }
  for (const Tick& tick : area.y.ticks()) {
    const double at = area.y.place(tick.value);
    const bool minor = tick.text.empty();
    if (!minor) svg.line({area.left, at}, {lines_end, at}, "grid");
    svg.line({area.left - (minor ? 3 : 5), at}, {area.left, at}, "axis");
    if (!minor) svg.text({area.left - 8, at + 4}, tick.text, "text", Anchor::end);
  }
  svg.polyline({{area.left, area.top}, {area.left, bottom}, {lines_end, bottom}}, "axis");
  svg.text({(area.left + lines_end) / 2, bottom + 36},
           fitted(axis_text(area.plot.x.label, area.plot.x.unit), text_size, lines_end - area.left), "text",
           Anchor::middle);
  svg.vertical_text({16, (area.top + bottom) / 2},
                    fitted(axis_text(area.plot.y.label, area.plot.y.unit), text_size, area_height));
}

void draw_levels(Svg& svg, const PlotArea& area) {
  for (const PlotLevel& level : area.plot.levels) {
    if (!has_place(level.value, area.plot.y.scale)) continue;
    const double at = area.y.place(level.value);
    svg.line({area.left, at}, {lines_end, at}, "level");
    svg.text({lines_end - 4, at - 5}, level.label, "quiet", Anchor::end);
  }
}

// The runs of neighbouring points that can be drawn.
std::vector<std::vector<SvgPoint>> pieces(const PlotArea& area, const PlotSeries& series) {
  std::vector<std::vector<SvgPoint>> result(1);
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (area.shows(series, i))
      result.back().push_back(area.place(series, i));
    else
      result.emplace_back();
  }
  return result;
}

std::string value_text(const PlotAxis& axis, double value) {
  return fmt::format("{} {}{}{}", axis.label, number_text(value), axis.unit.empty() ? "" : " ", axis.unit);
}

void draw_series(Svg& svg, const PlotArea& area, std::size_t index) {
  const PlotSeries& series = area.plot.series[index];
  const std::string css_class = "curve s" + colour_class(index) + (series.dashed ? " dashed" : "");
  for (const auto& piece : pieces(area, series))
    if (piece.size() > 1) svg.polyline(piece, css_class);
  const std::size_t count = series.x.size();
  const std::size_t every = count <= short_series ? 1 : (count - 1) / markers_of_long_series + 1;
  for (std::size_t i = 0; i < count; ++i) {
    if (!series.markers || !area.shows(series, i) || (i % every != 0 && i + 1 != count)) continue;
    const std::string point =
        value_text(area.plot.x, series.x[i]) + ", " + value_text(area.plot.y, series.y[i]);
    svg.marker(area.place(series, i), index, series.name.empty() ? point : series.name + ": " + point);
  }
}

// The last two points of a series that have a place on logarithmic axes.
std::vector<std::size_t> last_two(const PlotSeries& series) {
  std::vector<std::size_t> result;
  for (std::size_t i = series.x.size(); i-- > 0 && result.size() < 2;)
    if (has_place(series.x[i], Scale::logarithmic) && has_place(series.y[i], Scale::logarithmic))
      result.push_back(i);
  return result;
}

// A triangle whose longest side has the expected slope, beside the middle of the last two points' line: below
// it, or above it where there is no room.
void draw_slope(Svg& svg, const PlotArea& area, const PlotSeries& series) {
  const std::vector<std::size_t> ends = last_two(series);
  if (!series.expected_slope || ends.size() < 2 || area.plot.x.scale != Scale::logarithmic ||
      area.plot.y.scale != Scale::logarithmic)
    return;
  SvgPoint from = area.place(series, ends[0]);
  SvgPoint to = area.place(series, ends[1]);
  if (from.x > to.x) std::swap(from, to);
  if (to.x - from.x < 1) return;
  const double measured = (to.y - from.y) / (to.x - from.x);
  const double expected = *series.expected_slope * area.y.density() / area.x.density();
  const SvgPoint middle = {(from.x + to.x) / 2, (from.y + to.y) / 2};
  const double half = 0.3 * (to.x - from.x);
  const double distance = 10 + half * std::abs(expected - measured);
  const double rise = half * std::abs(expected);
  const double side = middle.y + distance + rise <= area.bottom - 2 ? 1 : -1;
  const SvgPoint start = {middle.x - half, middle.y + side * distance - half * expected};
  const SvgPoint end = {middle.x + half, middle.y + side * distance + half * expected};
  const bool corner_at_start = (side > 0) == (expected > 0);
  const SvgPoint corner = corner_at_start ? SvgPoint{start.x, end.y} : SvgPoint{end.x, start.y};
  svg.polygon({start, end, corner}, "slope");
  svg.text({corner.x + (corner_at_start ? -4 : 4), (start.y + end.y) / 2 + 4},
           number_text(*series.expected_slope), "quiet", corner_at_start ? Anchor::end : Anchor::start);
}

std::string legend_text(const PlotSeries& series) {
  const auto measured = measured_slope(series);
  if (!series.expected_slope || !measured) return series.name;
  return fmt::format("{}{}slope {}, expected {}", series.name, series.name.empty() ? "" : ": ",
                     number_text(*measured), number_text(*series.expected_slope));
}

Legend legend(const LinePlot& plot) {
  std::vector<Legend::Entry> entries;
  for (const PlotSeries& series : plot.series)
    entries.push_back({legend_text(series),
                       series.dashed ? Legend::Sample::dashed_line : Legend::Sample::line, series.markers});
  return {entries, line_plot_width};
}

}  // namespace

std::optional<double> measured_slope(const PlotSeries& series) {
  const std::vector<std::size_t> ends = last_two(series);
  if (ends.size() < 2) return std::nullopt;
  const double run = std::log(series.x[ends[0]] / series.x[ends[1]]);
  if (run == 0) return std::nullopt;
  return std::log(series.y[ends[0]] / series.y[ends[1]]) / run;
}

std::string to_svg(const LinePlot& plot) {
  check(plot);
  const Legend names = legend(plot);
  const PlotArea area = plot_area(plot, names.bottom() + 14);
  Svg svg(line_plot_width, area.bottom + axis_height, plot.title, plot.description);
  draw_axes(svg, area);
  draw_levels(svg, area);
  for (const PlotSeries& series : plot.series) draw_slope(svg, area, series);
  for (std::size_t i = 0; i < plot.series.size(); ++i) draw_series(svg, area, i);
  names.draw(svg);
  return svg.finished();
}

}  // namespace isopatch::app
