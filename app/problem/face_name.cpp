#include "app/problem/face_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

std::vector<std::string> names(const std::vector<geometry::Boundary>& boundaries) {
  std::vector<std::string> result;
  for (const auto& boundary : boundaries) result.push_back(boundary.name);
  return result;
}

}  // namespace

std::string listed_boundaries(const std::vector<geometry::Boundary>& boundaries) {
  return boundaries.empty() ? "the model names no boundaries"
                            : fmt::format("boundaries: {}", fmt::join(names(boundaries), ", "));
}

std::vector<geometry::PatchFace> faces_named(const std::string& text, int patch_count,
                                             const std::vector<geometry::Boundary>& boundaries,
                                             const Place& place) {
  for (const auto& boundary : boundaries)
    if (boundary.name == text) return boundary.faces;
  const auto colon = text.find(':');
  int patch = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + std::min(colon, text.size()), patch);
  if (colon == std::string::npos || problem != std::errc{} || end != text.data() + colon)
    throw error_at(place, fmt::format("no boundary is named \"{}\"{}; {}; or name a face as \"0:back\"", text,
                                      did_you_mean(text, names(boundaries)), listed_boundaries(boundaries)));
  if (patch < 0 || patch >= patch_count)
    throw error_at(place, fmt::format("face \"{}\" does not exist: the model has patches 0 to {}", text,
                                      patch_count - 1));
  std::vector<std::string> sides;
  for (const auto side : geometry::all_sides) {
    sides.emplace_back(name(side));
    if (text.substr(colon + 1) == sides.back()) return {geometry::PatchFace{PatchId(patch), side}};
  }
  throw error_at(
      place, fmt::format("face \"{}\" does not exist: a side is west, east, south, north, front or back{}",
                         text, did_you_mean(text.substr(colon + 1), sides)));
}

}  // namespace isopatch::app
