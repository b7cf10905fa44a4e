#include "geometry/models/plate.hpp"

#include <cmath>

#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/models/section.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* plate_model_name = "plate";

}  // namespace

void validate(const PlateOptions& options) {
  check_length(plate_model_name, "width", options.width);
  check_length(plate_model_name, "height", options.height);
  check_length(plate_model_name, "hole_radius", options.hole_radius);
  check_length(plate_model_name, "thickness", options.thickness);
  check_below(plate_model_name, "hole_radius", options.hole_radius, "width", options.width);
  check_below(plate_model_name, "hole_radius", options.hole_radius, "height", options.height);
}

PatchSet plate_model(const PlateOptions& options) {
  validate(options);
  const double w = options.width;
  const double h = options.height;
  const Eigen::Vector3d up(0, 0, options.thickness);
  const Angle split = Angle::radians(std::atan2(h, w));
  const auto hole = [&](Angle from, Angle to) { return arc({0, 0, 0}, options.hole_radius, from, to); };
  const NurbsSurface lower = section_between(hole(Angle(), split), segment({w, 0, 0}, {w, h, 0}));
  const NurbsSurface upper = section_between(hole(split, Angle::degrees(90)), segment({w, h, 0}, {0, h, 0}));
  ModelBuilder builder;
  builder.add(extruded(lower, up), {{Side::west, "hole"},
                                    {Side::east, "x_max"},
                                    {Side::south, "y_min"},
                                    {Side::front, "bottom"},
                                    {Side::back, "top"}});
  builder.add(extruded(upper, up), {{Side::west, "hole"},
                                    {Side::east, "y_max"},
                                    {Side::north, "x_min"},
                                    {Side::front, "bottom"},
                                    {Side::back, "top"}});
  builder.join({PatchId(0), Side::north}, {PatchId(1), Side::south});
  return builder.patches();
}

}  // namespace isopatch::geometry
