#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isopatch {

/// The known name that most resembles `name` by edit distance, or "" if none is near
/// (distance at most a third of the longer name's length, and at least 1 allowed).
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// " (did you mean 'degree'?)" or "".
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

}  // namespace isopatch
