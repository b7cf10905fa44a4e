#include "app/plots/graph_drawing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/plots/internal/legend.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

constexpr double drawing_width = 640;
constexpr double margin = 34;  // for the numbers outside

void check(const GraphDrawing& drawing) {
  const auto count = static_cast<int>(drawing.vertices.size());
  for (const GraphDrawing::Edge& edge : drawing.edges)
    if (edge.from < 0 || edge.to < 0 || edge.from >= count || edge.to >= count ||
        edge.series >= drawing.series.size())
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format(
              "an edge of the drawing '{}' goes from vertex {} to {} in series {}; there are {} and {}",
              drawing.title, edge.from, edge.to, edge.series, count, drawing.series.size()));
}

Legend legend_of(const GraphDrawing& drawing) {
  std::vector<Legend::Entry> entries;
  for (const std::string& name : drawing.series) entries.push_back({name, Legend::Sample::line, false});
  return Legend(std::move(entries), drawing_width);
}

}  // namespace

std::string to_svg(const GraphDrawing& drawing) {
  check(drawing);
  const Legend legend = legend_of(drawing);
  const double radius = drawing_width / 2 - margin;
  const double middle = legend.bottom() + drawing_width / 2;
  const auto place = [&](const std::array<double, 2>& at) {
    return SvgPoint{drawing_width / 2 + radius * at[0], middle - radius * at[1]};
  };
  Svg svg(drawing_width, middle + drawing_width / 2, drawing.title, drawing.description);
  legend.draw(svg);
  for (const GraphDrawing::Label& label : drawing.labels) {
    const SvgPoint at = place(label.at);
    svg.text({at.x, at.y + 4}, label.text, "quiet", Anchor::middle);
  }
  for (const GraphDrawing::Edge& edge : drawing.edges)
    svg.line(place(drawing.vertices[static_cast<std::size_t>(edge.from)]),
             place(drawing.vertices[static_cast<std::size_t>(edge.to)]),
             "curve s" + colour_class(edge.series));
  for (std::size_t i = 0; i < drawing.vertices.size(); ++i) {
    const auto& [x, y] = drawing.vertices[i];
    const SvgPoint at = place(drawing.vertices[i]);
    svg.marker(at, 0, fmt::format("vertex {}", i));
    // The number a little outwards.
    const double length = std::max(std::hypot(x, y), 1e-9);
    svg.text({at.x + 13 * x / length, at.y - 13 * y / length + 4}, fmt::format("{}", i), "text",
             Anchor::middle);
  }
  return svg.finished();
}

}  // namespace isopatch::app
