#pragma once

#include <string>

struct _XDisplay;  // what Xlib.h calls Display; its macros would get in the way of Eigen

namespace isopatch::app {

/// A connection to an X server that is fit for OpenGL. VTK ends the process where it is not, so we look
/// first.
class XDisplay {
 public:
  /// @throws Error unsupported
  explicit XDisplay(const std::string& name);
  ~XDisplay();
  XDisplay(const XDisplay&) = delete;
  XDisplay& operator=(const XDisplay&) = delete;

  ::_XDisplay* get() const { return display_; }

  /// Why a display cannot be drawn on; empty if it can.
  static std::string problem(const std::string& name);

 private:
  ::_XDisplay* display_ = nullptr;
};

}  // namespace isopatch::app
