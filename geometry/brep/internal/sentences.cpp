#include "geometry/brep/internal/sentences.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace isopatch::geometry {

std::string listed(const std::vector<std::string>& sentences) {
  const std::size_t shown = std::min<std::size_t>(4, sentences.size());
  const std::string text = fmt::format(
      "{}", fmt::join(sentences.begin(), sentences.begin() + static_cast<std::ptrdiff_t>(shown), "; "));
  return shown < sentences.size() ? fmt::format("{}; and {} more", text, sentences.size() - shown) : text;
}

}  // namespace isopatch::geometry
