#pragma once

namespace isopatch::app {

/// In pixels, the origin at the lower left.
struct Box {
  double left = 0;
  double bottom = 0;
  double right = 0;
  double top = 0;
};

struct PictureSize {
  int width = 1600;
  int height = 1200;
};

/// Which part of the picture is for what.
struct Layout {
  PictureSize size;
  double font = 0;  ///< height of the text, pixels
  Box part;         ///< for the part itself
  Box bar;          ///< for the colours of the bar; its title is above, its numbers to the right
  double axes = 0;  ///< length of the axes of the cross; its centre is at (axes_x, axes_y)
  double axes_x = 0;
  double axes_y = 0;
  double margin = 0;  ///< around all, pixels
};

struct LayoutParts {
  bool bar = true;
  bool caption = true;
};

Layout layout(const PictureSize& size, const LayoutParts& parts);

}  // namespace isopatch::app
