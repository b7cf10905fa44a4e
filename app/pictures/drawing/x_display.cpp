#include "app/pictures/drawing/internal/x_display.hpp"

#include <GL/glx.h>
#include <X11/Xlib.h>
#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

/// Whether the server offers a kind of frame buffer that VTK can use.
bool has_opengl(::Display* display) {
  int ignored = 0;
  if (glXQueryExtension(display, &ignored, &ignored) == 0) return false;
  constexpr int wanted[] = {GLX_DRAWABLE_TYPE,
                            GLX_WINDOW_BIT,
                            GLX_RENDER_TYPE,
                            GLX_RGBA_BIT,
                            GLX_RED_SIZE,
                            1,
                            GLX_GREEN_SIZE,
                            1,
                            GLX_BLUE_SIZE,
                            1,
                            None};
  int count = 0;
  GLXFBConfig* kinds = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  if (kinds != nullptr) XFree(kinds);
  return count > 0;
}

}  // namespace

std::string XDisplay::problem(const std::string& name) {
  ::Display* display = XOpenDisplay(name.c_str());
  if (display == nullptr) return fmt::format("the display '{}' does not answer", name);
  const bool good = has_opengl(display);
  XCloseDisplay(display);
  return good ? "" : fmt::format("the display '{}' has no OpenGL", name);
}

XDisplay::XDisplay(const std::string& name) : display_(XOpenDisplay(name.c_str())) {
  if (display_ == nullptr)
    throw Error(ErrorCode::unsupported, fmt::format("the display '{}' does not answer", name));
}

XDisplay::~XDisplay() {
  XCloseDisplay(display_);
}

}  // namespace isopatch::app
