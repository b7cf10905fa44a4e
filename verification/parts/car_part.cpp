#include "verification/parts/internal/car_part.hpp"

#include <BRepBuilderAPI_Transform.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec2d.hxx>

#include <cmath>

#include "verification/parts/internal/shapes.hpp"

namespace isopatch::parts {
namespace {

constexpr double hub = 30, hub_bore = 15, hub_height = 40;
constexpr double eye = 17, eye_bore = 9, eye_height = 24;
constexpr double web = 14;  // height
const gp_Vec2d to_eye(110, 48);

/// A point of the arm's plane by its way along the arm and across it.
gp_Pnt2d on_arm(double along, double across) {
  const gp_Vec2d u = to_eye.Normalized(), v(-u.Y(), u.X());
  return gp_Pnt2d((along * u + across * v).XY());
}

/// Where a circle of a radius through two points has its centre, to the left of the way from one to the
/// other.
gp_Pnt2d centre_left(gp_Pnt2d from, gp_Pnt2d to, double radius) {
  const gp_Vec2d chord(from, to);
  const double half = chord.Magnitude() / 2;
  const gp_Vec2d left(-chord.Y() / (2 * half), chord.X() / (2 * half));
  return from.Translated(chord / 2 + left * std::sqrt(radius * radius - half * half));
}

/// From the hub to the eye, with a bow outwards and one inwards.
Outline arm() {
  const double end = to_eye.Magnitude() - 6;
  const gp_Pnt2d a = on_arm(20, -14), b = on_arm(end, -10), c = on_arm(end, 10), d = on_arm(20, 14);
  return Outline(a)
      .arc_to(b, centre_left(b, a, 160), false)
      .line_to(c)
      .arc_to(d, centre_left(c, d, 140))
      .line_to(a);
}

TopoDS_Shape mirrored(const TopoDS_Shape& shape) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2({0, 0, 0}, {0, 1, 0}));
  return BRepBuilderAPI_Transform(shape, mirror, true).Shape();
}

}  // namespace

Part car_part() {
  const TopoDS_Shape bone = prism(arm(), 0, web),
                     end = upright_cylinder(to_eye.X(), to_eye.Y(), eye, 0, eye_height);
  const TopoDS_Shape bore = upright_cylinder(to_eye.X(), to_eye.Y(), eye_bore, -1, eye_height + 1);
  const TopoDS_Shape outside =
      joined({upright_cylinder(0, 0, hub, 0, hub_height), bone, end, mirrored(bone), mirrored(end)});
  return {without(outside, {upright_cylinder(0, 0, hub_bore, -1, hub_height + 1), bore, mirrored(bore)}),
          {{"shaft", {-hub_bore, 0, 20}},
           {"left eye", {to_eye.X() + eye_bore, to_eye.Y(), 12}},
           {"right eye", {to_eye.X() + eye_bore, -to_eye.Y(), 12}}},
          {}};
}

}  // namespace isopatch::parts
