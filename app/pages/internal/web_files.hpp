#pragma once

#include <string_view>

namespace isopatch::app {

/// The files of web/ as they were when the program was built.
std::string_view web_page();
std::string_view web_style();
/// three.js, then ours in the order of their names.
std::string_view web_scripts();

}  // namespace isopatch::app
