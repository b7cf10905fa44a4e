#pragma once

#include <string>
#include <vector>

#include "app/study/config_value.hpp"

namespace isopatch::app {

/// A table as text: the same for tables that say the same, however their files are laid out; other numbers,
/// texts or names give another text.
/// @param without  names of entries that are left out
std::string config_text(const ConfigTable& table, const std::vector<std::string>& without = {});

}  // namespace isopatch::app
