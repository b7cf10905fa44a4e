#include "app/problem/face_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string_view>

#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

using geometry::Boundary;
using geometry::PatchFace;

constexpr std::string_view face_form = "face:";
constexpr std::string_view colour_form = "colour:";
constexpr std::string_view side_form = "side:";

std::vector<std::string> names(const std::vector<Boundary>& boundaries) {
  std::vector<std::string> result;
  for (const auto& boundary : boundaries) result.push_back(boundary.name);
  return result;
}

std::string in_small_letters(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// "#ff0000".
bool is_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c); });
}

/// What solids call a boundary whose face has the name of a colour.
bool is_face_named_as_colour(std::string_view name) {
  return name.starts_with(face_form) && is_colour(name.substr(face_form.size()));
}

/// How a boundary is written where its name alone has another meaning too.
std::string full_form(const std::string& name) {
  if (is_face_named_as_colour(name)) return name;
  return std::string(is_colour(name) ? colour_form : face_form) + name;
}

bool is_meant(const std::string& text, const std::string& name) {
  if (text == name || text == full_form(name)) return true;
  if (is_face_named_as_colour(name)) return text == name.substr(face_form.size());
  if (!is_colour(name)) return false;
  const std::string small = in_small_letters(text);
  return small == in_small_letters(name) || small == full_form(in_small_letters(name));
}

/// A text as the side of a patch, as far as it is one.
struct SideText {
  std::optional<int> patch;
  std::string side;
  std::optional<geometry::Side> found;
};

SideText side_text(std::string_view text) {
  if (text.starts_with(side_form)) text.remove_prefix(side_form.size());
  const std::size_t colon = std::min(text.find(':'), text.size());
  SideText result;
  int patch = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + colon, patch);
  if (colon == text.size() || problem != std::errc{} || end != text.data() + colon) return result;
  result.patch = patch;
  result.side = text.substr(colon + 1);
  for (const auto side : geometry::all_sides)
    if (name(side) == result.side) result.found = side;
  return result;
}

bool is_side(const SideText& text, int patch_count) {
  return text.found && *text.patch >= 0 && *text.patch < patch_count;
}

/// What a name may mean.
struct Meaning {
  std::string form;
  std::string what;
  std::vector<PatchFace> faces;  ///< increasing
};

std::vector<Meaning> meanings(const std::string& text, int patch_count,
                              const std::vector<Boundary>& boundaries, const SideNaming& from_input) {
  std::vector<Meaning> result;
  for (const Boundary& boundary : boundaries)
    if (is_meant(text, boundary.name))
      result.push_back({full_form(boundary.name),
                        is_colour(boundary.name) ? "the faces of that colour" : "the faces of that name",
                        boundary.faces});
  const SideText side = side_text(text);
  if (is_side(side, patch_count)) {
    const PatchFace face{PatchId(*side.patch), *side.found};
    result.push_back({fmt::format("{}{}:{}", side_form, *side.patch, side.side),
                      fmt::format("the {} side of patch {}", side.side, *side.patch),
                      {from_input ? from_input(face) : face}});
  }
  return result;
}

Error unknown_name(const std::string& text, int patch_count, const std::vector<Boundary>& boundaries,
                   const Place& place) {
  const SideText side = side_text(text);
  if (!side.patch)
    return error_at(place,
                    fmt::format("no boundary is named \"{}\"{}; {}; or name a face as \"0:back\"; isopatch "
                                "info says where each is",
                                text, did_you_mean(text, names(boundaries)), listed_boundaries(boundaries)));
  if (*side.patch < 0 || *side.patch >= patch_count)
    return error_at(place, fmt::format("face \"{}\" does not exist: the model has patches 0 to {}", text,
                                       patch_count - 1));
  std::vector<std::string> sides;
  for (const auto known : geometry::all_sides) sides.emplace_back(name(known));
  return error_at(
      place, fmt::format("face \"{}\" does not exist: a side is west, east, south, north, front or back{}",
                         text, did_you_mean(side.side, sides)));
}

std::vector<PatchFace> sorted(std::vector<PatchFace> faces) {
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

std::string listed_boundaries(const std::vector<Boundary>& boundaries) {
  return boundaries.empty() ? "the model names no boundaries"
                            : fmt::format("boundaries: {}", fmt::join(names(boundaries), ", "));
}

std::vector<PatchFace> faces_named(const std::string& text, int patch_count,
                                   const std::vector<Boundary>& boundaries, const Place& place,
                                   const SideNaming& from_input) {
  const std::vector<Meaning> found = meanings(text, patch_count, boundaries, from_input);
  if (found.empty()) throw unknown_name(text, patch_count, boundaries, place);
  for (const Meaning& other : found)
    if (sorted(other.faces) != sorted(found.front().faces))
      throw error_at(place,
                     fmt::format("the name \"{}\" has two meanings: {}, which is \"{}\" in full, and {}, "
                                 "\"{}\"; write one of these",
                                 text, found.front().what, found.front().form, other.what, other.form));
  return found.front().faces;
}

PatchFace side_named(const std::string& text, int patch_count) {
  const SideText side = side_text(text);
  if (!is_side(side, patch_count)) throw unknown_name(text, patch_count, {}, {});
  return {PatchId(*side.patch), *side.found};
}

}  // namespace isopatch::app
