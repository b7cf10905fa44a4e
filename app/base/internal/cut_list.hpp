#pragma once

#include <fmt/format.h>

#include <string>

namespace isopatch::app {

/// Longer lists are printed to here only, unless all of it is asked for.
constexpr std::size_t short_list = 24;

/// The line below a list that was cut; nothing where it was not.
inline std::string cut(std::size_t shown, std::size_t total, const char* what) {
  return shown < total ? fmt::format("  ... and {} more {} (--all lists them)\n", total - shown, what) : "";
}

}  // namespace isopatch::app
