#include "app/commands/console.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace isopatch::app {
namespace {

std::string labelled(const Console& console, const char* label, const char* colour,
                     const std::string& message) {
  if (!console.colours) return fmt::format("isopatch: {}: {}\n", label, message);
  return fmt::format("isopatch: \033[1;{}m{}:\033[0m {}\n", colour, label, message);
}

}  // namespace

void Console::warn(const std::string& message) const {
  err << labelled(*this, "warning", "33", message) << std::flush;
}

void Console::fail(const std::string& message) const {
  err << labelled(*this, "error", "31", message) << std::flush;
}

Progress ProgressDisplay::progress() {
  if (console_.quiet) return {};
  return {[this](std::string_view phase, double share) { show(phase, share); }};
}

void ProgressDisplay::clear() {
  if (line_open_) console_.err << "\r\033[K" << std::flush;
  line_open_ = false;
}

void ProgressDisplay::show(std::string_view told, double share) {
  const int percent = static_cast<int>(100 * std::clamp(share, 0.0, 1.0));
  const std::string_view phase = told.substr(0, told.find('\t'));
  const std::string_view details = phase == told ? "" : told.substr(phase.size() + 1);
  const bool same_phase = phase == phase_;
  if (same_phase && ((percent == percent_ && details == details_) || !console_.err_is_terminal)) return;
  phase_ = phase;
  details_ = details;
  percent_ = percent;
  if (console_.err_is_terminal) {
    const std::string how_far =
        details.empty() ? fmt::format(" {:3d} %", percent) : fmt::format(": {}", details);
    console_.err << fmt::format("\r\033[K{}{}", phase, how_far) << std::flush;
    line_open_ = true;
  } else {
    console_.err << fmt::format("isopatch: {}\n", phase) << std::flush;
  }
}

}  // namespace isopatch::app
