#include "geometry/models/cook.hpp"

#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/models/section.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* cook_model_name = "cook";

// The membrane's point at shares (s, t) of its width and its height there.
Eigen::Vector3d place(const CookOptions& options, double s, double t) {
  const double bottom = s * options.rise;
  const double top = (1 - s) * options.left_height + s * (options.rise + options.right_height);
  return {s * options.width, (1 - t) * bottom + t * top, 0};
}

}  // namespace

void validate(const CookOptions& options) {
  check_length(cook_model_name, "width", options.width);
  check_length(cook_model_name, "left_height", options.left_height);
  check_length(cook_model_name, "right_height", options.right_height);
  check_range(cook_model_name, "rise", options.rise, -1e100, 1e100);
  check_length(cook_model_name, "thickness", options.thickness);
  check_count(cook_model_name, "patches along x", options.patches[0]);
  check_count(cook_model_name, "patches along y", options.patches[1]);
  check_total(cook_model_name, 1.0 * options.patches[0] * options.patches[1]);
}

PatchSet cook_model(const CookOptions& options) {
  validate(options);
  const int columns = options.patches[0], rows = options.patches[1];
  ModelBuilder builder;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto side = [&](int column) {
        const double s = static_cast<double>(column) / columns;
        return segment(place(options, s, static_cast<double>(j) / rows),
                       place(options, s, static_cast<double>(j + 1) / rows));
      };
      std::vector<std::pair<Side, std::string_view>> names = {{Side::front, "bottom"}, {Side::back, "top"}};
      if (i == 0) names.emplace_back(Side::west, "x_min");
      if (i + 1 == columns) names.emplace_back(Side::east, "x_max");
      if (j == 0) names.emplace_back(Side::south, "y_min");
      if (j + 1 == rows) names.emplace_back(Side::north, "y_max");
      builder.add(extruded(section_between(side(i), side(i + 1)), {0, 0, options.thickness}), names);
    }
  builder.join_grid({columns, rows, 1});
  return builder.patches();
}

}  // namespace isopatch::geometry
