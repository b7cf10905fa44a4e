#pragma once

#include <string>
#include <vector>

#include "app/pictures/camera.hpp"
#include "app/pictures/colours.hpp"
#include "app/pictures/layout.hpp"
#include "app/pictures/surface.hpp"

namespace isopatch::app {

enum class Align { left, centre, right };

/// A line of text; pixels from the lower left, the middle of the text's height at `y`.
struct PictureText {
  std::string text;
  double x = 0;
  double y = 0;
  double font = 0;
  Align align = Align::left;
  Colour colour;
};

/// A filled convex polygon; pixels from the lower left.
struct PicturePolygon {
  std::vector<Eigen::Vector2d> corners;
  Colour colour;
};

/// Lines of one colour.
struct ColouredLines {
  Lines lines;
  Colour colour;
  double width = 1;  ///< pixels
};

/// All that is drawn; later items lie over earlier ones.
struct Picture {
  PictureSize size;
  Camera camera;
  Surface surface;              ///< values in [0, 1], from the first to the last colour of the palette
  std::vector<Colour> palette;  ///< equally wide, at least one
  Lines patch_lines;
  Lines element_lines;
  std::vector<ColouredLines> coloured_lines;
  std::vector<PicturePolygon> polygons;
  std::vector<PictureText> texts;
  double line_width = 1;     ///< of patch edges, pixels; half of it for elements
  bool transparent = false;  ///< no white background
};

}  // namespace isopatch::app
