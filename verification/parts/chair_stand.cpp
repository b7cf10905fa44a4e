#include "verification/parts/internal/chair_stand.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>

#include "verification/parts/internal/shapes.hpp"
#include "verification/parts/internal/splines.hpp"

namespace isopatch::parts {
namespace {

constexpr double height = 67.5, middle = 112.5;  // y of the plane of symmetry
constexpr double hub_x = -45, hub_radius = 55.575, sector_end = 22.5;
const double sector = std::tan(std::numbers::pi / 5);  // slope of the planes between the fifths
constexpr double end_x = 207, end_radius = 18.45, pin_radius = 5.6925;
constexpr double ring_radius = 23.4, pin_bore = 0.4 * pin_radius;  // of the ring and the pin, inside

/// Places along the arm, x, and its half width there.
constexpr std::array<std::array<double, 2>, 7> half_widths = {{{45, 30.15},
                                                               {65.25, 22.39},
                                                               {78.75, 20.03},
                                                               {106.9, 18.36},
                                                               {135, 19.37},
                                                               {180, 21.11},
                                                               {end_x, end_radius}}};

TopoDS_Edge arc(double x, double radius, gp_Pnt2d from, gp_Pnt2d to, bool counterclockwise) {
  const gp_Ax2 frame(gp_Pnt(x, middle, 0), counterclockwise ? gp::DZ() : gp::DZ().Reversed());
  return BRepBuilderAPI_MakeEdge(gp_Circ(frame, radius), gp_Pnt(from.X(), from.Y(), 0),
                                 gp_Pnt(to.X(), to.Y(), 0));
}

TopoDS_Edge line(gp_Pnt2d from, gp_Pnt2d to) {
  return BRepBuilderAPI_MakeEdge(gp_Pnt(from.X(), from.Y(), 0), gp_Pnt(to.X(), to.Y(), 0)).Edge();
}

/// The upper side (1) from the hub to the end, the lower one (-1).
std::vector<gp_Pnt2d> side(int sign) {
  std::vector<gp_Pnt2d> points = {{sector_end, middle + sign * sector * (sector_end - hub_x)}};
  for (const auto& [x, half] : half_widths) points.emplace_back(x, middle + sign * half);
  return points;
}

/// On the planes between the fifths, at a distance from the hub's axis.
gp_Pnt2d on_plane(double radius, int sign) {
  const double angle = std::numbers::pi / 5;
  return {hub_x + radius * std::cos(angle), middle + sign * radius * std::sin(angle)};
}

TopoDS_Shape arm() {
  const auto on_hub = [](int sign) { return on_plane(hub_radius, sign); };
  const std::vector<gp_Pnt2d> below = side(-1);
  std::vector<gp_Pnt2d> above = side(1);
  std::reverse(above.begin(), above.end());
  const TopoDS_Wire outline =
      wire({line(on_hub(-1), below.front()), spline_through(below, 0),
            arc(end_x, end_radius, below.back(), above.front(), true), spline_through(above, 0),
            line(above.back(), on_hub(1)), arc(hub_x, hub_radius, on_hub(1), on_hub(-1), false)});
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline, true).Face(), gp_Vec(0, 0, height)).Shape();
}

/// Through the arm along y, its outline given in x and z.
TopoDS_Shape slot() {
  const std::vector<gp_Pnt2d> points = {{63.8, 22.9},  {85, 17.8},    {118.5, 16.6}, {151.9, 17.5},
                                        {173.6, 22.8}, {177.9, 32.6}, {170.3, 40.4}, {150.5, 47.2},
                                        {118.5, 49.3}, {86.4, 46.7},  {67, 40.1},    {59, 32.5}};
  const std::vector<gp_Pnt2d> cuts = {{78, 20}, {159, 20}, {158, 44}, {78, 44}};
  gp_Trsf upright;  // z becomes -y
  upright.SetRotation(gp::OX(), std::numbers::pi / 2);
  return BRepBuilderAPI_Transform(
             ruled(closed_spline(points, 0, -180, cuts), closed_spline(points, 0, -40, cuts)), upright)
      .Shape();
}

TopoDS_Shape ring() {
  const TopoDS_Wire outline =
      wire({line(on_plane(ring_radius, -1), on_plane(hub_radius, -1)),
            arc(hub_x, hub_radius, on_plane(hub_radius, -1), on_plane(hub_radius, 1), true),
            line(on_plane(hub_radius, 1), on_plane(ring_radius, 1)),
            arc(hub_x, ring_radius, on_plane(ring_radius, 1), on_plane(ring_radius, -1), false)});
  const TopoDS_Shape longer =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline, true).Face(), gp_Vec(0, 0, 2 * height)).Shape();
  // Top and bottom of a prism are one face in two places, of which STEP files name one.
  return without(longer, {box({-100, 0, height}, {100, 300, 3 * height})});
}

TopoDS_Shape pin() {
  return without(cylinder({end_x, middle, 0}, gp::DZ(), pin_radius, height),
                 {cylinder({end_x, middle, -1}, gp::DZ(), pin_bore, height + 2)});
}

}  // namespace

Part chair_stand() {
  return {without(arm(), {slot(), cylinder({end_x, middle, -1}, gp::DZ(), pin_radius, height + 2)}),
          {{"pin hole", {end_x + pin_radius, middle, 30}},
           {"hub bore", {hub_x + hub_radius, middle, 30}},
           {"right sector plane", {15, middle - 60 * sector, 30}},
           {"left sector plane", {15, middle + 60 * sector, 30}}},
          {}};
}

Part chair_stand_with_ring_and_pin() {
  Part result = chair_stand();
  result.name = "stand";
  const double inside = (ring_radius + hub_radius) / 2, wall = (pin_bore + pin_radius) / 2;
  const auto beside = [&](int sign) {
    return gp_Pnt(on_plane(inside, sign).X(), on_plane(inside, sign).Y(), 30);
  };
  result.others = {{"ring",
                    ring(),
                    {{"ring top", {hub_x + inside, middle, height}},
                     {"right plane of the ring", beside(-1)},
                     {"left plane of the ring", beside(1)}}},
                   {"pin", pin(), {{"pin bottom", {end_x + wall, middle, 0}}}}};
  return result;
}

}  // namespace isopatch::parts
