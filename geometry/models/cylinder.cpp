#include "geometry/models/cylinder.hpp"

#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/models/section.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* cylinder_model_name = "cylinder";
constexpr Angle full_turn = Angle::degrees(360);

// Counted in whole pieces, so that 360 degrees in any number of pieces close exactly.
Angle fraction(Angle angle, int index, int count) {
  return angle * (static_cast<double>(index) / count);
}
double between(double low, double high, int index, int count) {
  const double share = static_cast<double>(index) / count;
  return (1 - share) * low + share * high;
}

int patches_around(const CylinderOptions& options) {
  return options.patches_around > 0 ? options.patches_around : arc_piece_count(options.angle);
}

}  // namespace

void validate(const CylinderOptions& options) {
  check_length(cylinder_model_name, "inner_radius", options.inner_radius);
  check_length(cylinder_model_name, "outer_radius", options.outer_radius);
  check_below(cylinder_model_name, "inner_radius", options.inner_radius, "outer_radius",
              options.outer_radius);
  check_length(cylinder_model_name, "height", options.height);
  check_angle(cylinder_model_name, "angle", options.angle, full_turn);
  check_count(cylinder_model_name, "radial_patches", options.radial_patches);
  check_count(cylinder_model_name, "axial_patches", options.axial_patches);
  if (options.patches_around != 0)
    check_range(cylinder_model_name, "patches_around", options.patches_around,
                arc_piece_count(options.angle, Angle::degrees(120)), 1000);
  check_total(cylinder_model_name,
              1.0 * patches_around(options) * options.radial_patches * options.axial_patches);
}

PatchSet cylinder_model(const CylinderOptions& options) {
  validate(options);
  const bool closed = options.angle == full_turn;
  const int around = patches_around(options);
  ModelBuilder builder;
  for (int k = 0; k < options.axial_patches; ++k)
    for (int j = 0; j < around; ++j)
      for (int i = 0; i < options.radial_patches; ++i) {
        const double z = between(0, options.height, k, options.axial_patches);
        const double top = between(0, options.height, k + 1, options.axial_patches);
        const Angle from = fraction(options.angle, j, around);
        const Angle to = fraction(options.angle, j + 1, around);
        const auto circle = [&](int layer) {
          const double radius =
              between(options.inner_radius, options.outer_radius, layer, options.radial_patches);
          return arc({0, 0, z}, radius, from, to);
        };
        std::vector<std::pair<Side, std::string_view>> names;
        if (i == 0) names.emplace_back(Side::west, "inner");
        if (i + 1 == options.radial_patches) names.emplace_back(Side::east, "outer");
        if (j == 0 && !closed) names.emplace_back(Side::south, "start");
        if (j + 1 == around && !closed) names.emplace_back(Side::north, "end");
        if (k == 0) names.emplace_back(Side::front, "bottom");
        if (k + 1 == options.axial_patches) names.emplace_back(Side::back, "top");
        builder.add(extruded(section_between(circle(i), circle(i + 1)), {0, 0, top - z}), names);
      }
  builder.join_grid({options.radial_patches, around, options.axial_patches}, {false, closed, false});
  return builder.patches();
}

}  // namespace isopatch::geometry
