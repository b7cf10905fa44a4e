#include "app/render/picture_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "app/base/choices.hpp"
#include "app/base/units.hpp"
#include "app/results/stored_results.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

[[noreturn]] void reject(const std::string& message) {
  throw Error(ErrorCode::invalid_argument, message);
}

/// The value of a name; an error lists the names and says which is nearest.
template <typename Value>
Value choose(const std::string& option, const std::string& name, const Choices<Value>& known) {
  if (const Value* found = find_choice(known, name)) return *found;
  reject(fmt::format("{}: there is no '{}'{}; choose one of {}", option, name,
                     did_you_mean(name, names(known)), fmt::join(names(known), ", ")));
}

PictureField field_of(const PictureWords& words, bool has_results) {
  static const Choices<PictureField> known = {
      {"von_mises", PictureField::von_mises},   {"displacement", PictureField::displacement},
      {"patch", PictureField::patch},           {"jacobian", PictureField::jacobian},
      {"conditions", PictureField::conditions}, {"none", PictureField::none}};
  if (words.field.empty()) {
    if (!words.component.empty()) return PictureField::displacement;
    return has_results ? PictureField::von_mises : PictureField::patch;
  }
  return choose("--field", words.field, known);
}

std::optional<int> component_of(const PictureWords& words, PictureField field) {
  static const Choices<int> known = {{"x", 0}, {"y", 1}, {"z", 2}};
  if (words.component.empty()) return std::nullopt;
  const int component = choose("--component", words.component, known);
  if (field != PictureField::displacement)
    reject(fmt::format("--component goes with --field displacement, not with {}", words.field));
  return component;
}

Dimension dimension_of(PictureField field) {
  if (field == PictureField::von_mises) return dimensions::pressure;
  return field == PictureField::displacement ? dimensions::length : dimensions::none;
}

double quantity(const std::string& option, const std::string& text, const Dimension& dimension) {
  try {
    const Quantity found = parse_quantity(text);
    if (found.dimension == dimension || found.dimension == dimensions::none) return found.value;
    reject(fmt::format("expected {}, got {} in '{}'", describe(dimension), describe(found.dimension), text));
  } catch (const Error& error) {
    reject(fmt::format("{}: {}", option, error.what()));
  }
}

std::optional<ValueRange> range_of(const std::string& text, PictureField field) {
  if (text.empty()) return std::nullopt;
  if (field == PictureField::patch || field == PictureField::none || field == PictureField::conditions)
    reject("--range goes with --field von_mises, displacement or jacobian");
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    reject(fmt::format("--range: expected two values such as '0,300 MPa', got '{}'", text));
  const Dimension dimension = dimension_of(field);
  const ValueRange range = {quantity("--range", text.substr(0, comma), dimension),
                            quantity("--range", text.substr(comma + 1), dimension)};
  if (!(range.low < range.high))
    reject(fmt::format("--range: the first value must be below the second, got '{}'", text));
  return range;
}

std::optional<double> deformation_of(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const double factor = [&] {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole ? value : std::nan("");
  }();
  if (!std::isfinite(factor) || factor < 0)
    reject(fmt::format("--deformation: expected auto or a factor of at least 0, got '{}'", text));
  return factor;
}

Eigen::Vector3d direction_of(const std::string& option, const std::string& text) {
  try {
    return parse_parameter(text);
  } catch (const Error& error) {
    reject(fmt::format("{}: {}", option, error.what()));
  }
}

std::optional<Eigen::Vector3d> up_of(const std::string& text) {
  static const Choices<Eigen::Vector3d> known = {
      {"x", Eigen::Vector3d::UnitX()}, {"y", Eigen::Vector3d::UnitY()}, {"z", Eigen::Vector3d::UnitZ()}};
  if (text.empty()) return std::nullopt;
  return text.find(',') == std::string::npos ? choose("--up", text, known) : direction_of("--up", text);
}

View view_of(const PictureWords& words) {
  Choices<View> known;
  for (const std::string& name : view_names()) known.push_back({name, *named_view(name)});
  const bool named = words.view.find(',') == std::string::npos;
  const Eigen::Vector3d toward_eye =
      named ? choose("--view", words.view, known).toward_eye : direction_of("--view", words.view);
  try {
    return view_from(toward_eye, up_of(words.up));
  } catch (const Error& error) {
    reject(fmt::format("--view {}: {}", words.view, error.what()));
  }
}

PictureSize size_of(const std::string& text) {
  constexpr int least = 100;
  constexpr int most = 8000;
  PictureSize size;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, size.width);
  const bool two = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
  const auto second = two ? std::from_chars(first.ptr + 1, end, size.height) : first;
  const auto fits = [](int value) { return value >= least && value <= most; };
  if (!two || second.ec != std::errc() || second.ptr != end || !fits(size.width) || !fits(size.height))
    reject(fmt::format("--size: expected WIDTHxHEIGHT in pixels, {} to {} each, such as 1600x1200, got '{}'",
                       least, most, text));
  return size;
}

std::optional<Cut> cut_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  static const Choices<int> known = {{"x", 0}, {"y", 1}, {"z", 2}};
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    reject(fmt::format("--clip: expected x, y or z with a position, such as 'x=20 mm', got '{}'", text));
  return Cut{choose("--clip", text.substr(0, equals), known),
             quantity("--clip", text.substr(equals + 1), dimensions::length)};
}

void check_number(const std::string& option, double value, double least, double most) {
  if (!(value >= least && value <= most))
    reject(fmt::format("{}: expected {} to {}, got {}", option, least, most, value));
}

}  // namespace

PictureOptions parse_picture_options(const PictureWords& words, bool has_results) {
  static const Choices<PictureEdges> edges = {
      {"patches", PictureEdges::patches}, {"elements", PictureEdges::elements}, {"none", PictureEdges::none}};
  PictureOptions options;
  options.field = field_of(words, has_results);
  options.component = component_of(words, options.field);
  const bool of_results =
      options.field == PictureField::von_mises || options.field == PictureField::displacement;
  if (of_results && !has_results)
    reject(
        fmt::format("--field {}: the input has no results; solve the study with isopatch run and render its "
                    "results.h5",
                    options.field == PictureField::von_mises ? "von_mises" : "displacement"));
  options.range = range_of(words.range, options.field);
  check_number("--percentile", words.percentile, 51, 100);
  options.percentile = words.percentile;
  options.deformation = deformation_of(words.deformation);
  if (options.deformation.value_or(0) != 0 && !has_results)
    reject("--deformation: the input has no results, so it has no deformation");
  options.view = view_of(words);
  check_number("--zoom", words.zoom, 0.01, 100);
  options.zoom = words.zoom;
  options.size = size_of(words.size);
  options.edges = choose("--edges", words.edges, edges);
  options.cut = cut_of(words.clip);
  options.caption = words.caption;
  options.transparent = words.transparent;
  options.bar = !words.no_bar;
  return options;
}

}  // namespace isopatch::app
