#include "geometry/models/elliptic_plate.hpp"

#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/models/section.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* elliptic_plate_model_name = "elliptic_plate";

// A quarter of an ellipse: a circle's, stretched along the axes, which leaves the weights.
NurbsCurve quarter(double along_x, double along_y, double z) {
  const NurbsCurve circle = arc({0, 0, 0}, 1, Angle(), Angle::degrees(90));
  Eigen::Matrix3Xd points = Eigen::Vector3d(along_x, along_y, 1).asDiagonal() * circle.control_points();
  points.row(2).setConstant(z);
  return NurbsCurve(circle.knots(), points, circle.weights());
}

}  // namespace

void validate(const EllipticPlateOptions& options) {
  check_length(elliptic_plate_model_name, "inner_x", options.inner_x);
  check_length(elliptic_plate_model_name, "inner_y", options.inner_y);
  check_length(elliptic_plate_model_name, "outer_x", options.outer_x);
  check_length(elliptic_plate_model_name, "outer_y", options.outer_y);
  check_length(elliptic_plate_model_name, "thickness", options.thickness);
  check_below(elliptic_plate_model_name, "inner_x", options.inner_x, "outer_x", options.outer_x);
  check_below(elliptic_plate_model_name, "inner_y", options.inner_y, "outer_y", options.outer_y);
  check_count(elliptic_plate_model_name, "layers", options.layers);
}

PatchSet elliptic_plate_model(const EllipticPlateOptions& options) {
  validate(options);
  const auto height = [&](int layer) { return options.thickness * layer / options.layers; };
  ModelBuilder builder;
  for (int k = 0; k < options.layers; ++k) {
    const NurbsSurface section = section_between(quarter(options.inner_x, options.inner_y, height(k)),
                                                 quarter(options.outer_x, options.outer_y, height(k)));
    std::vector<std::pair<Side, std::string_view>> names = {
        {Side::west, "inner"}, {Side::east, "outer"}, {Side::south, "y_min"}, {Side::north, "x_min"}};
    if (k == 0) names.emplace_back(Side::front, "bottom");
    if (k + 1 == options.layers) names.emplace_back(Side::back, "top");
    builder.add(extruded(section, {0, 0, height(k + 1) - height(k)}), names);
  }
  builder.join_grid({1, 1, options.layers});
  return builder.patches();
}

}  // namespace isopatch::geometry
