#pragma once

#include <string>
#include <vector>

namespace isopatch::geometry {

/// The first four sentences in a row, and how many more there are.
std::string listed(const std::vector<std::string>& sentences);

}  // namespace isopatch::geometry
