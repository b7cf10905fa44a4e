#include "geometry/models/bracket.hpp"

#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/models/section.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* bracket_model_name = "bracket";

}  // namespace

void validate(const BracketOptions& options) {
  check_length(bracket_model_name, "leg", options.leg);
  check_length(bracket_model_name, "width", options.width);
  check_length(bracket_model_name, "thickness", options.thickness);
  check_below(bracket_model_name, "width", options.width, "leg", options.leg);
}

PatchSet bracket_model(const BracketOptions& options) {
  validate(options);
  const double w = options.width;
  const double leg = options.leg;
  const auto brick = [&](double left, double right, double low, double high) {
    const NurbsSurface section =
        section_between(segment({left, low, 0}, {left, high, 0}), segment({right, low, 0}, {right, high, 0}));
    return extruded(section, {0, 0, options.thickness});
  };
  ModelBuilder builder;
  builder.add(brick(0, w, 0, w),
              {{Side::west, "x_min"}, {Side::south, "y_min"}, {Side::front, "bottom"}, {Side::back, "top"}});
  builder.add(brick(w, leg, 0, w), {{Side::south, "y_min"},
                                    {Side::east, "x_max"},
                                    {Side::north, "inner"},
                                    {Side::front, "bottom"},
                                    {Side::back, "top"}});
  builder.add(brick(0, w, w, leg), {{Side::west, "x_min"},
                                    {Side::north, "y_max"},
                                    {Side::east, "inner"},
                                    {Side::front, "bottom"},
                                    {Side::back, "top"}});
  builder.join({PatchId(0), Side::east}, {PatchId(1), Side::west});
  builder.join({PatchId(0), Side::north}, {PatchId(2), Side::south});
  return builder.patches();
}

}  // namespace isopatch::geometry
