#pragma once

#include <string>

namespace isopatch::app {

/// An X server without a screen (Xvfb) for this process alone, on a free display. It ends with this object,
/// and also when the process is ended from outside.
class VirtualDisplay {
 public:
  /// @throws Error unsupported  Xvfb is not installed or does not start; with the package's name
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  /// ":99"
  const std::string& name() const { return name_; }

 private:
  void stop();
  int process_ = -1;
  std::string name_;
};

}  // namespace isopatch::app
