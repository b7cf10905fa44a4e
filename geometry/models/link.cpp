#include "geometry/models/link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/base/error.hpp"
#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/models/section.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* link_model_name = "link";

// One end of the link: an eye about the origin whose shank leaves along +x.
struct Eye {
  double bore_radius;
  double outer_radius;
  double half_width;
  double fillet_radius;

  // Of the point where the round end meets the fillet, seen from the eye's centre.
  Angle fillet_angle() const {
    return Angle::radians(std::asin((half_width + fillet_radius) / (outer_radius + fillet_radius)));
  }
  // Of the ends of the bore wall that faces the shank; further round it would be a poor patch.
  Angle bore_angle() const { return std::min(fillet_angle(), Angle::degrees(60)); }
  // x of the fillet's centre, where the shank proper begins.
  double shank_start() const { return (outer_radius + fillet_radius) * std::cos(fillet_angle().radians()); }
};

Eye left_eye(const LinkOptions& o) {
  return {o.left_bore_radius, o.left_outer_radius, 0.5 * o.shank_width, o.fillet_radius};
}
Eye right_eye(const LinkOptions& o) {
  return {o.right_bore_radius, o.right_outer_radius, 0.5 * o.shank_width, o.fillet_radius};
}

// The least distance of an eye's front from its centre, so that the wall about the bore stays thick enough.
double nearest_front(const Eye& eye) {
  return eye.bore_radius + 0.25 * (eye.outer_radius - eye.bore_radius);
}

// The largest, so that the neck stays long enough.
double farthest_front(const Eye& eye) {
  const double corner = eye.outer_radius * std::cos(eye.fillet_angle().radians());
  return 0.5 * (corner + eye.shank_start());
}

// x of the middle of the curve where the eye's patches end towards the shank. The curve bulges so that it
// halves the right angle between the eye's radius and the fillet, as far as eye and neck allow.
double front_middle(const Eye& eye) {
  const double angle = eye.fillet_angle().radians();
  const double corner_x = eye.outer_radius * std::cos(angle);
  const double corner_y = eye.outer_radius * std::sin(angle);
  const double halving = corner_x + 0.5 * corner_y * std::tan(std::max(0.0, angle - 0.25 * std::numbers::pi));
  return std::min(std::max(halving, nearest_front(eye)), farthest_front(eye));
}

// That curve: a parabola between the two fillets' first points.
NurbsCurve front_of(const Eye& eye) {
  const double angle = eye.fillet_angle().radians();
  const Eigen::Vector3d top(eye.outer_radius * std::cos(angle), eye.outer_radius * std::sin(angle), 0);
  const Eigen::Vector3d bottom(top.x(), -top.y(), 0);
  Eigen::Matrix3Xd points(3, 3);
  points << bottom, Eigen::Vector3d(2 * front_middle(eye) - top.x(), 0, 0), top;
  return NurbsCurve({KnotVector::bezier(2)}, points);
}

// From the eye's front to the straight shank, between the two fillets.
NurbsSurface neck_of(const Eye& eye) {
  const Angle angle = eye.fillet_angle();
  const double x = eye.shank_start();
  const double y = eye.half_width + eye.fillet_radius;
  const NurbsCurve top = arc({x, y, 0}, eye.fillet_radius, angle + Angle::degrees(180), Angle::degrees(270));
  const NurbsCurve bottom =
      arc({x, -y, 0}, eye.fillet_radius, Angle::degrees(180) - angle, Angle::degrees(90));
  const NurbsSurface straight = elevate_degree(ruled(bottom, top), 1, 1);
  Eigen::Matrix3Xd points = straight.control_points();
  const double bulge = front_of(eye).control_points()(0, 1) - points(0, 3);
  points(0, 3) += bulge;
  points(0, 4) += 0.5 * bulge;
  return NurbsSurface(straight.knots(), points, straight.weights());
}

NurbsVolume turned(const NurbsVolume& volume, const Eigen::Vector3d& center) {
  Eigen::Matrix3Xd points = volume.control_points();
  points.topRows<2>() *= -1;
  points.colwise() += center;
  return NurbsVolume(volume.knots(), points, volume.weights());
}

constexpr int eye_patches = 5;  // one that faces the shank, three around, the neck

// How the patches of one end meet.
void join_eye(ModelBuilder& builder, int first) {
  builder.join_row(first, 1, eye_patches - 1, 1, true);
  builder.join({PatchId(first), Side::east}, {PatchId(first + eye_patches - 1), Side::west});
}

// The patches of one end; `place` puts them where they belong.
template <class Place>
void add_eye(ModelBuilder& builder, const Eye& eye, const Eigen::Vector3d& up, std::string_view bore,
             std::string_view end, Place place) {
  const Eigen::Vector3d center = Eigen::Vector3d::Zero();
  const Angle turn = Angle::degrees(360);
  const Angle on_bore = eye.bore_angle();
  const Angle outside = eye.fillet_angle();
  const NurbsSurface facing = section_between(arc(center, eye.bore_radius, -on_bore, on_bore), front_of(eye));
  builder.add(place(extruded(facing, up)),
              {{Side::west, bore}, {Side::front, "bottom"}, {Side::back, "top"}});
  constexpr int pieces = 3;
  const auto piece = [&](Angle first, double radius, int i) {
    const Angle step = (turn - first * 2) / pieces;
    return arc(center, radius, first + step * i, first + step * (i + 1));
  };
  for (int i = 0; i < pieces; ++i) {
    const NurbsSurface ring =
        section_between(piece(on_bore, eye.bore_radius, i), piece(outside, eye.outer_radius, i));
    builder.add(place(extruded(ring, up)),
                {{Side::west, bore}, {Side::east, end}, {Side::front, "bottom"}, {Side::back, "top"}});
  }
  builder.add(place(extruded(neck_of(eye), up)),
              {{Side::south, "sides"}, {Side::north, "sides"}, {Side::front, "bottom"}, {Side::back, "top"}});
}

// Quadratic across, like the necks it joins.
NurbsSurface shank_section(double left, double right, double half_width) {
  return elevate_degree(section_between(segment({left, -half_width, 0}, {left, half_width, 0}),
                                        segment({right, -half_width, 0}, {right, half_width, 0})),
                        1, 1);
}

void check_front(std::string_view side, const Eye& eye) {
  if (farthest_front(eye) < nearest_front(eye))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format(
            "{}: {}_bore_radius is {:g}; between this bore and the shank's fillets too little is left "
            "of {}_outer_radius {:g}; make the bore or shank_width smaller or fillet_radius larger",
            link_model_name, side, eye.bore_radius, side, eye.outer_radius));
}

}  // namespace

void validate(const LinkOptions& options) {
  check_length(link_model_name, "distance", options.distance);
  check_length(link_model_name, "left_bore_radius", options.left_bore_radius);
  check_length(link_model_name, "right_bore_radius", options.right_bore_radius);
  check_length(link_model_name, "left_outer_radius", options.left_outer_radius);
  check_length(link_model_name, "right_outer_radius", options.right_outer_radius);
  check_length(link_model_name, "shank_width", options.shank_width);
  check_length(link_model_name, "fillet_radius", options.fillet_radius);
  check_length(link_model_name, "thickness", options.thickness);
  check_count(link_model_name, "shank_patches", options.shank_patches);
  check_below(link_model_name, "left_bore_radius", options.left_bore_radius, "left_outer_radius",
              options.left_outer_radius);
  check_below(link_model_name, "right_bore_radius", options.right_bore_radius, "right_outer_radius",
              options.right_outer_radius);
  const double smaller = std::min(options.left_outer_radius, options.right_outer_radius);
  check_below(link_model_name, "shank_width", options.shank_width, "twice the smaller outer radius",
              2 * smaller);
  check_front("left", left_eye(options));
  check_front("right", right_eye(options));
  const double needed = left_eye(options).shank_start() + right_eye(options).shank_start();
  if (!(options.distance > needed))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("{}: distance is {:g}; it must be above {:g}, which eyes and fillets take; a smaller "
                    "fillet_radius takes less",
                    link_model_name, options.distance, needed));
}

PatchSet link_model(const LinkOptions& options) {
  validate(options);
  const Eigen::Vector3d up(0, 0, options.thickness);
  const Eigen::Vector3d right_center(options.distance, 0, 0);
  const Eye left = left_eye(options);
  const Eye right = right_eye(options);
  ModelBuilder builder;
  add_eye(builder, left, up, "bore_left", "end_left", [](const NurbsVolume& v) { return v; });
  add_eye(builder, right, up, "bore_right", "end_right",
          [&](const NurbsVolume& v) { return turned(v, right_center); });
  const double start = left.shank_start();
  const double length = options.distance - right.shank_start() - start;
  for (int i = 0; i < options.shank_patches; ++i) {
    const double low = start + length * i / options.shank_patches;
    const double high =
        i + 1 == options.shank_patches ? start + length : start + length * (i + 1) / options.shank_patches;
    builder.add(
        extruded(shank_section(low, high, left.half_width), up),
        {{Side::south, "sides"}, {Side::north, "sides"}, {Side::front, "bottom"}, {Side::back, "top"}});
  }
  join_eye(builder, 0);
  join_eye(builder, eye_patches);
  const PatchId left_neck(eye_patches - 1), right_neck(2 * eye_patches - 1);
  const PatchId shank(2 * eye_patches), end(2 * eye_patches + options.shank_patches - 1);
  builder.join({left_neck, Side::east}, {shank, Side::west});
  builder.join_row(shank.value, 1, options.shank_patches, 0);
  // The right end is the left one turned by 180 degrees, so its neck runs the other way across.
  builder.join({end, Side::east}, {right_neck, Side::east}, {.flip_first = true});
  return builder.patches();
}

}  // namespace isopatch::geometry
