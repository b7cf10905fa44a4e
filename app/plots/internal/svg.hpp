#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isopatch::app {

struct SvgPoint {
  double x = 0;
  double y = 0;
};

enum class Anchor { start, middle, end };

/// Text that may stand in XML: marked up where it must be, without characters that XML forbids.
std::string escaped(std::string_view text);

/// About the width of a text. @param size  of the font, in units of the picture
double text_width(std::string_view text, double size);
/// The text, cut off with an ellipsis where it would be wider than that.
std::string fitted(const std::string& text, double size, double width);

/// "s3": the class of the colour of a series or part, from 0; the colours are used again after the last.
std::string colour_class(std::size_t index);

inline constexpr double text_size = 12;
inline constexpr double title_size = 15;

/// A picture that grows element by element. Classes are those of the style sheet in svg.cpp.
class Svg {
 public:
  Svg(double width, double height, const std::string& title, const std::string& description);

  void text(SvgPoint at, const std::string& text, const std::string& css_class = "text",
            Anchor anchor = Anchor::start);
  /// Upwards, centred at a point.
  void vertical_text(SvgPoint at, const std::string& text);
  void line(SvgPoint from, SvgPoint to, const std::string& css_class);
  void polyline(const std::vector<SvgPoint>& points, const std::string& css_class);
  void polygon(const std::vector<SvgPoint>& points, const std::string& css_class);
  /// @param tooltip  appears where the pointer rests
  void rectangle(SvgPoint corner, double width, double height, const std::string& css_class,
                 const std::string& tooltip = "");
  /// The mark of a series: circle, square, triangle, ... in the colour of its index.
  void marker(SvgPoint at, std::size_t index, const std::string& tooltip = "");

  std::string finished() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
};

}  // namespace isopatch::app
