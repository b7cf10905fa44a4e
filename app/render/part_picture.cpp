#include "app/render/part_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/base/engineering_units.hpp"
#include "app/pictures/annotations.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

/// Finer than on a page that one turns: chords of a tenth of a pixel.
iga::PartSamples samples_of(const LoadedInput& input) {
  const iga::SamplingOptions options{.chord = 1e-4, .most_per_element = 32, .most_points = 1'000'000};
  return input.result ? iga::sample_part(input.model, input.result->field, options)
                      : iga::sample_part(input.model, input.model.patches(), options);
}

std::string field_name(const PictureOptions& options) {
  switch (options.field) {
    case PictureField::von_mises:
      return "von Mises stress";
    case PictureField::displacement:
      return options.component ? fmt::format("displacement {}", "xyz"[*options.component]) : "displacement";
    case PictureField::jacobian:
      return "scaled Jacobian";
    case PictureField::patch:
      return "patches";
    case PictureField::conditions:  // drawn by themselves
    case PictureField::none:
      break;
  }
  return "";
}

std::string_view si_unit(PictureField field) {
  return field == PictureField::von_mises ? "Pa" : field == PictureField::displacement ? "m" : "";
}

/// In pictures, which unlike terminals all show it, micro has its own letter.
std::string in_picture(std::string text) {
  const std::size_t at = text.find("um");
  return at == std::string::npos ? text : text.replace(at, 1, "\u00b5");
}

/// How values become colours, and what is said about them.
struct Colouring {
  ValueScale scale;
  ValueRange full;
  ScaledUnit unit;
  bool is_length_of_vector = false;  ///< never negative, so the scale begins at 0
};

/// The run's own largest value of the field, if it is one that runs look for.
std::optional<double> largest_of(const LoadedInput& input, const PictureOptions& options) {
  if (!input.summary) return std::nullopt;
  if (options.field == PictureField::von_mises) return input.summary->largest_von_mises();
  if (options.field == PictureField::displacement && !options.component)
    return input.summary->max_displacement;
  return std::nullopt;
}

Colouring colouring(const Surface& surface, const PictureOptions& options, std::optional<double> largest) {
  Colouring result;
  result.is_length_of_vector = options.field == PictureField::von_mises ||
                               (options.field == PictureField::displacement && !options.component);
  result.full = full_range(surface);
  ValueRange range = options.range.value_or(
      options.field == PictureField::jacobian ? result.full : range_of_area(surface, options.percentile));
  if (result.is_length_of_vector && !options.range) range.low = 0;
  if (largest) {
    result.full.high = *largest;
    if (!options.range) range.high = std::min(range.high, *largest);
  }
  result.unit = unit_for(std::max(std::abs(range.low), std::abs(range.high)), si_unit(options.field));
  result.scale =
      options.range ? exact_scale(range, result.unit.factor) : round_scale(range, result.unit.factor);
  return result;
}

/// In the unit of the scale, so that all values of a picture compare.
std::string value_text(double value, const ScaledUnit& unit) {
  const double number = value / unit.factor;
  const bool long_one = std::abs(number) >= 1e4 && std::abs(number) < 1e7;
  return fmt::format("{}{}{}", long_one ? fmt::format("{:.0f}", number) : fmt::format("{:.4g}", number),
                     unit.symbol.empty() ? "" : " ", unit.symbol);
}

/// Smallest and largest value, which may lie outside of the colours' range.
std::vector<std::string> extremes(const Colouring& colours) {
  std::vector<std::string> texts;
  texts.push_back("max " + value_text(colours.full.high, colours.unit));
  if (!colours.is_length_of_vector) texts.push_back("min " + value_text(colours.full.low, colours.unit));
  return texts;
}

ColourBar bar_of(const Colouring& colours, const PictureOptions& options) {
  ColourBar bar;
  bar.title = {field_name(options)};
  if (!colours.unit.symbol.empty()) bar.title.push_back(in_picture(colours.unit.symbol));
  bar.ticks = colours.scale.ticks;
  for (const std::string& text : extremes(colours)) bar.notes.push_back(in_picture(text));
  return bar;
}

std::string range_text(const Colouring& colours, const PictureOptions& options) {
  std::string text =
      fmt::format("{} {} to {}", field_name(options), value_text(colours.scale.range.low, colours.unit),
                  value_text(colours.scale.range.high, colours.unit));
  const auto found = extremes(colours);
  return text + fmt::format(" ({})", fmt::join(found, ", "));
}

std::string deformation_text(double factor) {
  if (factor == 0) return "not deformed";
  if (factor == 1) return "true deformation";
  return fmt::format("deformation x {:.6g}", factor);
}

/// "x 20" with the sign that is not on every keyboard.
std::string with_times_sign(std::string text) {
  const std::size_t at = text.find(" x ");
  return at == std::string::npos ? text : text.replace(at, 3, " \u00d7 ");
}

double deformation_of(const LoadedInput& input, const PictureOptions& options,
                      const iga::PartSamples& samples) {
  if (!input.result) return 0;
  return options.deformation ? *options.deformation : visible_deformation(samples, input.model.size());
}

/// How faces are coloured by what a study does to them.
enum Mark { untouched, held, loaded, mark_count };

std::map<geometry::PatchFace, double> marked_faces(const LoadedInput& input, const PictureOptions& options) {
  std::map<geometry::PatchFace, double> marks;
  if (options.field != PictureField::conditions) return marks;
  if (input.held.empty() && input.loaded.empty())
    throw Error(
        ErrorCode::invalid_argument,
        "--field conditions shows faces of supports and loads, which the input does not have; give a study");
  for (const FaceSelection& selection : input.held)
    for (const geometry::PatchFace& face : select_faces(input.model, selection).faces) marks[face] = held;
  for (const FaceSelection& selection : input.loaded)
    for (const geometry::PatchFace& face : select_faces(input.model, selection).faces) marks[face] = loaded;
  return marks;
}

/// Light grey, blue, red.
std::vector<Colour> mark_colours() {
  return {{176, 190, 204}, {31, 119, 180}, {214, 39, 40}};
}

/// The part itself: surface and edges, cut if asked for.
void add_part(Picture& picture, const LoadedInput& input, const std::vector<PatchShape>& shape,
              const PictureOptions& options) {
  const bool elements = options.edges == PictureEdges::elements;
  picture.surface = outer_surface(input.model, shape, marked_faces(input, options));
  if (options.edges != PictureEdges::none) picture.patch_lines = patch_edges(input.model, shape);
  if (elements) picture.element_lines = element_edges(input.model, shape);
  if (!options.cut) return;
  const Lines outline = cut_outline(picture.surface, *options.cut);
  picture.surface = joined(clipped(picture.surface, *options.cut), section(shape, *options.cut));
  if (options.edges != PictureEdges::none)
    picture.patch_lines = joined(clipped(picture.patch_lines, *options.cut), outline);
  picture.element_lines = clipped(picture.element_lines, *options.cut);
  if (picture.surface.triangles.empty())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("--clip: nothing of the part is left below {} = {}", "xyz"[options.cut->axis],
                            with_unit(options.cut->position, "m")));
}

bool has_scale(PictureField field) {
  return field != PictureField::patch && field != PictureField::none && field != PictureField::conditions;
}

}  // namespace

PartPicture part_picture(const LoadedInput& input, const PictureOptions& options) {
  const iga::PartSamples samples = samples_of(input);
  const double deformation = deformation_of(input, options, samples);
  PartPicture result;
  Picture& picture = result.picture;
  picture.size = options.size;
  picture.transparent = options.transparent;
  add_part(picture, input, part_shape(samples, {options.field, options.component, deformation}), options);

  const bool bar = options.bar && has_scale(options.field);
  const std::string shape_text = input.result ? deformation_text(deformation) : "";
  const std::string caption =
      options.caption.value_or(input.title + (shape_text.empty() ? "" : ", " + with_times_sign(shape_text)));
  const Layout places = layout(options.size, {.bar = bar, .caption = !caption.empty()});
  picture.camera = fitted(options.view, picture.surface.points, places, options.zoom);
  picture.line_width = 0.06 * places.font;

  if (has_scale(options.field)) {
    const Colouring colours = colouring(picture.surface, options, largest_of(input, options));
    picture.palette = viridis();
    picture.surface.values = scaled(picture.surface.values, colours.scale.range);
    if (bar) add_colour_bar(picture, places, bar_of(colours, options));
    result.description = range_text(colours, options);
  } else if (options.field == PictureField::conditions) {
    picture.palette = mark_colours();
    picture.surface.values = (picture.surface.values.array() + 0.5) / mark_count;
    result.description = fmt::format("{} patches, supports blue, loads red", input.model.patch_count());
  } else {
    const int count = options.field == PictureField::patch ? input.model.patch_count() : 1;
    picture.palette = count > 1 ? patch_colours(count) : std::vector<Colour>{{176, 190, 204}};
    picture.surface.values = (picture.surface.values.array() + 0.5) / count;
    result.description = fmt::format("{} patches", input.model.patch_count());
  }
  add_axes(picture, places);
  if (!caption.empty()) add_caption(picture, places, caption);
  if (!shape_text.empty()) result.description += ", " + shape_text;
  return result;
}

}  // namespace isopatch::app
