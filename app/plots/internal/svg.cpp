#include "app/plots/internal/svg.hpp"

#include <fmt/format.h>

#include <array>

namespace isopatch::app {
namespace {

// Okabe and Ito's colours, which people with any colour vision tell apart, and a grey; darkest first.
constexpr std::array<const char*, 8> palette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#7a5195", "#8c8c8c"};

// What stands on an area of the same index.
constexpr std::array<const char*, 8> on_palette = {"#ffffff", "#ffffff", "#ffffff", "#222222",
                                                   "#222222", "#222222", "#ffffff", "#222222"};

// The plain colour first: programs that know no variables skip the second declaration.
std::string declaration(const char* property, const std::string& variable, const char* fallback) {
  return fmt::format("{0}:{2};{0}:var(--plot-{1},{2})", property, variable, fallback);
}

std::string rule(const std::string& selector, const std::string& declarations) {
  return fmt::format(".isopatch-plot .{}{{{}}}\n", selector, declarations);
}

std::string style_sheet() {
  const std::string ink = declaration("fill", "ink", "#222222");
  const std::string faint = declaration("fill", "faint", "#5f6368");
  std::string text = "<style>\n";
  text += fmt::format(".isopatch-plot{{{};font-size:{}px}}\n",
                      "font-family:system-ui,-apple-system,'Segoe UI','DejaVu Sans',sans-serif", text_size);
  text += rule("paper", declaration("fill", "paper", "#ffffff"));
  text += rule("text", ink) + rule("quiet", faint);
  text += rule("title", fmt::format("{};font-size:{}px;font-weight:600", ink, title_size));
  text += rule("axis", "fill:none;" + declaration("stroke", "ink", "#222222"));
  text += rule("grid", "fill:none;stroke-width:.7;" + declaration("stroke", "grid", "#dddddd"));
  text += rule("level", "fill:none;stroke-dasharray:2 3;" + declaration("stroke", "ink", "#222222"));
  text += rule("slope", "fill:none;stroke-width:1;" + declaration("stroke", "faint", "#5f6368"));
  text += rule("curve", "fill:none;stroke-width:1.8;stroke-linejoin:round;stroke-linecap:round");
  text += rule("dashed", "stroke-dasharray:6 4");
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const std::string name = std::to_string(i + 1);
    text += rule("s" + name, declaration("stroke", name, palette[i]));
    text += rule("v" + name, declaration("fill", "on-" + name, on_palette[i]));
    text += rule("f" + name, declaration("fill", name, palette[i]) + ";" +
                                 declaration("stroke", "paper", "#ffffff") + ";stroke-width:.8");
  }
  return text + "</style>\n";
}

std::string points_text(const std::vector<SvgPoint>& points) {
  std::string text;
  for (const SvgPoint& point : points)
    text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? "" : " ", point.x, point.y);
  return text;
}

const char* name(Anchor anchor) {
  return anchor == Anchor::start ? "start" : anchor == Anchor::middle ? "middle" : "end";
}

std::string tooltip_text(const std::string& tooltip) {
  return tooltip.empty() ? "" : "<title>" + escaped(tooltip) + "</title>";
}

// Bytes that begin a character of UTF-8.
bool begins_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

// About equal areas, corners relative to the middle.
std::vector<SvgPoint> outline(std::size_t shape) {
  static const std::array<std::vector<SvgPoint>, 5> outlines = {{
      {{-3.3, -3.3}, {3.3, -3.3}, {3.3, 3.3}, {-3.3, 3.3}},
      {{0, -4.6}, {4.4, 3.2}, {-4.4, 3.2}},
      {{0, -4.7}, {4.7, 0}, {0, 4.7}, {-4.7, 0}},
      {{0, 4.6}, {-4.4, -3.2}, {4.4, -3.2}},
      {{-1.5, -4.4},
       {1.5, -4.4},
       {1.5, -1.5},
       {4.4, -1.5},
       {4.4, 1.5},
       {1.5, 1.5},
       {1.5, 4.4},
       {-1.5, 4.4},
       {-1.5, 1.5},
       {-4.4, 1.5},
       {-4.4, -1.5},
       {-1.5, -1.5}},
  }};
  return outlines[shape % outlines.size()];
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      result += c;
    else
      result += ' ';
  }
  return result;
}

double text_width(std::string_view text, double size) {
  constexpr std::string_view narrow = ".,:;' ijl|!";
  double width = 0;
  for (const char c : text) {
    if (!begins_character(c)) continue;
    const bool wide = (c >= 'A' && c <= 'Z') || c == '&' || c == '@' || c == '%' || c == 'm' || c == 'w';
    width += wide ? .8 : narrow.find(c) != std::string_view::npos ? .32 : .6;
  }
  return width * size;
}

std::string fitted(const std::string& text, double size, double width) {
  if (text_width(text, size) <= width) return text;
  std::string cut = text;
  while (!cut.empty() && text_width(cut, size) + size > width) {
    while (!begins_character(cut.back())) cut.pop_back();
    cut.pop_back();
  }
  return cut + "\u2026";
}

std::string colour_class(std::size_t index) {
  return std::to_string(index % palette.size() + 1);
}

Svg::Svg(double width, double height, const std::string& title, const std::string& description)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"isopatch-plot\" role=\"img\" "
                        "viewBox=\"0 0 {:g} {:g}\">\n<title>{}</title>\n<desc>{}</desc>\n",
                        width, height, escaped(title), escaped(description)) +
            style_sheet()) {
  rectangle({0, 0}, width, height, "paper");
  text({8, 20}, fitted(title, title_size, width - 16), "title");
}

void Svg::text(SvgPoint at, const std::string& text, const std::string& css_class, Anchor anchor) {
  text_ += fmt::format("<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}</text>\n",
                       css_class, at.x, at.y, name(anchor), escaped(text));
}

void Svg::vertical_text(SvgPoint at, const std::string& text) {
  text_ += fmt::format(
      "<text class=\"text\" transform=\"translate({:.2f},{:.2f}) rotate(-90)\" text-anchor=\"middle\">{}"
      "</text>\n",
      at.x, at.y, escaped(text));
}

void Svg::line(SvgPoint from, SvgPoint to, const std::string& css_class) {
  text_ += fmt::format("<line class=\"{}\" x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>\n",
                       css_class, from.x, from.y, to.x, to.y);
}

void Svg::polyline(const std::vector<SvgPoint>& points, const std::string& css_class) {
  text_ += fmt::format("<polyline class=\"{}\" points=\"{}\"/>\n", css_class, points_text(points));
}

void Svg::polygon(const std::vector<SvgPoint>& points, const std::string& css_class) {
  text_ += fmt::format("<polygon class=\"{}\" points=\"{}\"/>\n", css_class, points_text(points));
}

void Svg::rectangle(SvgPoint corner, double width, double height, const std::string& css_class,
                    const std::string& tooltip) {
  text_ += fmt::format(
      "<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\">{}</rect>\n",
      css_class, corner.x, corner.y, width, height, tooltip_text(tooltip));
}

void Svg::marker(SvgPoint at, std::size_t index, const std::string& tooltip) {
  const std::string css_class = "f" + colour_class(index);
  constexpr std::size_t shapes = 6;
  if (index % shapes == 0) {
    text_ += fmt::format("<circle class=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3.7\">{}</circle>\n",
                         css_class, at.x, at.y, tooltip_text(tooltip));
    return;
  }
  std::vector<SvgPoint> corners = outline(index % shapes - 1);
  for (SvgPoint& corner : corners) corner = {at.x + corner.x, at.y + corner.y};
  text_ += fmt::format("<polygon class=\"{}\" points=\"{}\">{}</polygon>\n", css_class, points_text(corners),
                       tooltip_text(tooltip));
}

}  // namespace isopatch::app
