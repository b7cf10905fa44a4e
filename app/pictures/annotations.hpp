#pragma once

#include "app/pictures/picture.hpp"
#include "app/pictures/value_scale.hpp"

namespace isopatch::app {

/// A title above, a strip of colours with round numbers, and a note below.
struct ColourBar {
  std::vector<std::string> title;  ///< lines, from the top
  std::vector<Tick> ticks;
  std::vector<std::string> notes;  ///< lines, from the top
};
void add_colour_bar(Picture& picture, const Layout& layout, const ColourBar& bar);

/// The directions x, y, z as they lie in the view.
void add_axes(Picture& picture, const Layout& layout);

/// A line of text at the lower left.
void add_caption(Picture& picture, const Layout& layout, const std::string& caption);

}  // namespace isopatch::app
