#include "geometry/models/elbow.hpp"

#include <cmath>

#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/models/section.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* elbow_model_name = "elbow";

// The trace of a patch where the pipe goes on.
NurbsSurface end_of(const NurbsVolume& pipe) {
  return face_surface(pipe, Side::back);
}

// One quarter of the wall all the way along the pipe.
std::vector<NurbsVolume> pieces_along(const ElbowOptions& options, NurbsSurface section) {
  std::vector<NurbsVolume> pieces;
  if (options.inlet_length > 0) {
    pieces.push_back(extruded(section, {0, 0, options.inlet_length}));
    section = end_of(pieces.back());
  }
  const int bends = arc_piece_count(options.bend_angle);
  for (int i = 0; i < bends; ++i) {
    const Eigen::Vector3d center(options.bend_radius, 0, options.inlet_length);
    pieces.push_back(revolved(section, center, Eigen::Vector3d::UnitY(), options.bend_angle / bends));
    section = end_of(pieces.back());
  }
  if (options.outlet_length > 0) {
    const double angle = options.bend_angle.radians();
    const Eigen::Vector3d ahead(std::sin(angle), 0, std::cos(angle));
    pieces.push_back(extruded(section, options.outlet_length * ahead));
  }
  return pieces;
}

}  // namespace

void validate(const ElbowOptions& options) {
  check_length(elbow_model_name, "inner_radius", options.inner_radius);
  check_length(elbow_model_name, "outer_radius", options.outer_radius);
  check_below(elbow_model_name, "inner_radius", options.inner_radius, "outer_radius", options.outer_radius);
  check_length(elbow_model_name, "bend_radius", options.bend_radius);
  check_below(elbow_model_name, "outer_radius", options.outer_radius, "bend_radius", options.bend_radius);
  check_angle(elbow_model_name, "bend_angle", options.bend_angle, Angle::degrees(180));
  check_length_or_zero(elbow_model_name, "inlet_length", options.inlet_length);
  check_length_or_zero(elbow_model_name, "outlet_length", options.outlet_length);
}

PatchSet elbow_model(const ElbowOptions& options) {
  validate(options);
  constexpr int around = 4;
  ModelBuilder builder;
  int along = 0;
  for (int i = 0; i < around; ++i) {
    const Angle from = Angle::degrees(90 * i);
    const Angle to = Angle::degrees(90 * (i + 1));
    const auto circle = [&](double radius) { return arc({0, 0, 0}, radius, from, to); };
    const auto pieces =
        pieces_along(options, section_between(circle(options.inner_radius), circle(options.outer_radius)));
    along = static_cast<int>(pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      std::vector<std::pair<Side, std::string_view>> names = {{Side::west, "inner"}, {Side::east, "outer"}};
      if (k == 0) names.emplace_back(Side::front, "inlet");
      if (k + 1 == pieces.size()) names.emplace_back(Side::back, "outlet");
      builder.add(pieces[k], names);
    }
  }
  for (int i = 0; i < around; ++i) builder.join_row(i * along, 1, along, 2);
  for (int k = 0; k < along; ++k) builder.join_row(k, along, around, 1, true);
  return builder.patches();
}

}  // namespace isopatch::geometry
