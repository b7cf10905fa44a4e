#include "app/pictures/layout.hpp"

#include <cmath>

namespace isopatch::app {

Layout layout(const PictureSize& size, const LayoutParts& parts) {
  Layout result;
  result.size = size;
  result.font = 0.0195 * std::sqrt(static_cast<double>(size.width) * size.height);
  result.margin = result.font;
  const double font = result.font;
  const double column = (parts.bar ? 10 : 6.6) * font;  // bar above, axes below
  const double left = size.width - column;
  result.part = {result.margin, parts.caption ? 2.6 * font : result.margin, left - 0.5 * font,
                 size.height - result.margin};
  result.axes = 2.2 * font;
  result.axes_x = left + (parts.bar ? 3.6 : 3.3) * font;
  result.axes_y = 4.2 * font;
  result.bar = {left + 0.6 * font, 11.5 * font, left + 1.9 * font, size.height - 5.2 * font};
  return result;
}

}  // namespace isopatch::app
