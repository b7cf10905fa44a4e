#pragma once

#include <string>

#include "app/pictures/picture.hpp"

namespace isopatch::app {

/// Draws a picture: on the display that DISPLAY names if it is fit for that, otherwise on a virtual one.
/// @return  the bytes of a PNG
/// @throws Error unsupported  no display and no Xvfb, with what to install; the drawing module is not
/// installed
std::string draw(const Picture& picture);

}  // namespace isopatch::app
