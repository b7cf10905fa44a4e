#include "verification/parts/internal/basic_parts.hpp"

#include <BRepPrimAPI_MakeTorus.hxx>
#include <cmath>
#include <numbers>
#include <string>

#include "verification/parts/internal/shapes.hpp"

namespace isopatch::parts {
namespace {

constexpr double pi = std::numbers::pi;

const IsChosen every_edge = [](const gp_Pnt&) { return true; };

TopoDS_Shape bored(const TopoDS_Shape& shape, const std::vector<gp_Pnt>& bottoms, double radius,
                   double depth) {
  std::vector<TopoDS_Shape> drills;
  for (const gp_Pnt& bottom : bottoms)
    drills.push_back(cylinder(bottom.Translated({0, 0, -1}), gp::DZ(), radius, depth + 2));
  return without(shape, drills);
}

// Squares of 30 in a row, 10 thick, each with a bore of radius 8.
Part plate_with_bores(int count) {
  std::vector<gp_Pnt> places;
  std::vector<FaceName> names = {{"left", {0, 15, 5}}, {"right", {30.0 * count, 15, 5}}};
  for (int i = 0; i < count; ++i) {
    places.emplace_back(30 * i + 15, 15, 0);
    names.push_back({"bore " + std::to_string(i + 1), {30.0 * i + 23, 15, 5}});
  }
  return {bored(box({0, 0, 0}, {30.0 * count, 30, 10}), places, 8, 10), names, count * (9000 - 640 * pi)};
}

}  // namespace

Part bored_block() {
  return {bored(box({0, 0, 0}, {60, 40, 30}), {{30, 20, 0}}, 10, 30),
          {{"left", {0, 20, 15}}, {"bore", {40, 20, 15}}, {"right", {60, 20, 15}}},
          60 * 40 * 30 - 3000 * pi};
}

Part plate_with_2_bores() {
  return plate_with_bores(2);
}

Part plate_with_3_bores() {
  return plate_with_bores(3);
}

Part plate_with_5_bores() {
  return plate_with_bores(5);
}

// For a screw M8 whose head has 90 degrees.
Part countersunk_plate() {
  const TopoDS_Shape plate = bored(box({0, 0, 0}, {40, 30, 10}), {{20, 15, 0}}, 4.5, 10);
  return {without(plate, {cone({20, 15, 10}, gp::DZ().Reversed(), 9, 4, 5)}),
          {{"left", {0, 15, 5}}, {"countersink", {27, 15, 8}}, {"bore", {24.5, 15, 3}}},
          40 * 30 * 10 - pi * (5.5 * 4.5 * 4.5 + 4.5 * (81 + 40.5 + 20.25) / 3)};
}

// A corner, cut through the middles of its chamfers' ends, keeps a sixth of the cube of their size.
Part chamfered_block() {
  return {chamfered(box({0, 0, 0}, {60, 40, 30}), 4, every_edge),
          {{"left", {0, 20, 15}}, {"right", {60, 20, 15}}},
          60 * 40 * 30 - 4 * 8 * (52 + 32 + 22) - 8 * 64 * 5 / 6.0};
}

// What is within 5 of a smaller block.
Part rounded_block() {
  return {rounded(box({0, 0, 0}, {60, 40, 30}), 5, every_edge),
          {{"left", {0, 20, 15}}, {"right", {60, 20, 15}}},
          50 * 30 * 20 + 5 * 2 * (50 * 30 + 30 * 20 + 20 * 50) + pi * 25 * (50 + 30 + 20) + pi * 500 / 3};
}

Part bracket() {
  const TopoDS_Shape angle =
      prism_along_y(Outline::polygon({{0, 0}, {80, 0}, {80, 10}, {10, 10}, {10, 70}, {0, 70}}), 0, 60);
  const TopoDS_Shape rib = prism_along_y(Outline::polygon({{10, 10}, {50, 10}, {10, 50}}), 25, 35);
  return {bored(joined({angle, rib}), {{60, 14, 0}, {60, 46, 0}}, 6, 10),
          {{"wall", {0, 30, 40}}, {"bore 1", {66, 14, 5}}, {"bore 2", {66, 46, 5}}, {"base", {30, 30, 0}}},
          60 * 1400 + 800 * 10 - 2 * 360 * pi};
}

// The dimensions of examples/link.
Part link() {
  const double left = std::sqrt(40.0 * 40 - 28 * 28), right = std::sqrt(34.0 * 34 - 28 * 28);
  const auto on_left = [&](double y) { return gp_Pnt2d(left / 2, y * 14); };
  const auto on_right = [&](double y) { return gp_Pnt2d(100 - right * 14 / 34, y * 28.0 * 14 / 34); };
  const Outline outline = Outline(on_right(-1))
                              .arc_to(on_right(1), {100, 0})
                              .arc_to({100 - right, 8}, {100 - right, 28}, false)
                              .line_to({left, 8})
                              .arc_to(on_left(1), {left, 28}, false)
                              .arc_to(on_left(-1), {0, 0})
                              .arc_to({left, -8}, {left, -28}, false)
                              .line_to({100 - right, -8})
                              .arc_to(on_right(-1), {100 - right, -28}, false);
  const TopoDS_Shape bored_left = bored(prism(outline, 0, 12), {{0, 0, 0}}, 10, 12);
  return {bored(bored_left, {{100, 0, 0}}, 7, 12),
          {{"left bore", {10, 0, 6}}, {"right bore", {107, 0, 6}}},
          12 * (outline.area() - 149 * pi)};
}

// M20: 30 across flats, the thread as its core.
Part nut() {
  const Outline hexagon = Outline::regular(6, 15);
  return {bored(prism(hexagon, 0, 16), {{0, 0, 0}}, 8.65, 16),
          {{"thread", {8.65, 0, 8}}, {"top", {11, 0, 16}}, {"base", {11, 0, 0}}},
          16 * (hexagon.area() - 8.65 * 8.65 * pi)};
}

// The same, turned to 30 degrees at both ends, and countersunk.
Part chamfered_nut() {
  const double height = 4 * std::tan(pi / 6);
  const TopoDS_Shape blank =
      turned(Outline::polygon({{0, 0}, {14.5, 0}, {18.5, height}, {18.5, 16 - height}, {14.5, 16}, {0, 16}}));
  const TopoDS_Shape outside = common(prism(Outline::regular(6, 15), 0, 16), blank);
  const TopoDS_Shape thread = bored(outside, {{0, 0, 0}}, 8.65, 16);
  return {without(thread, {cone({0, 0, 0}, gp::DZ(), 10.5, 8, 2.5),
                           cone({0, 0, 16}, gp::DZ().Reversed(), 10.5, 8, 2.5)}),
          {{"thread", {8.65, 0, 8}}, {"top", {12, 0, 16}}, {"base", {12, 0, 0}}},
          {}};
}

Part round_bar() {
  return {cylinder({0, 0, 0}, gp::DZ(), 10, 60), {{"base", {1, 2, 0}}, {"top", {1, 2, 60}}}, 6000 * pi};
}

Part stepped_shaft() {
  const Outline half =
      Outline::polygon({{0, 0}, {20, 0}, {20, 40}, {15, 40}, {15, 90}, {10, 110}, {10, 150}, {0, 150}});
  return {turned(half), {{"left end", {1, 2, 0}}, {"right end", {1, 2, 150}}}, 2 * pi * half.first_moment()};
}

Part shaft_with_boss() {
  return {joined({cylinder({0, 0, 0}, gp::DX(), 20, 120), cylinder({60, 0, 0}, gp::DZ(), 10, 40)}),
          {{"left end", {0, 1, 2}}, {"boss", {61, 2, 40}}, {"right end", {120, 1, 2}}},
          {}};
}

// A plate with eight bolts, a hub with its fillet, a bore.
Part flange() {
  const auto half = [](double fillet) {
    return Outline::polygon({{25, 0}, {80, 0}, {80, 16}, {40, 16, fillet}, {40, 60}, {25, 60}});
  };
  const TopoDS_Shape blank = rounded_at(turned(half(0)), 5, {{40, 16}});
  return {bored(blank, on_circle(8, 60, 0), 7, 16),
          {{"base", {50, 0, 0}}, {"hub", {32, 1, 60}}, {"bore", {25, 0, 30}}, {"bolt 1", {67, 0, 8}}},
          2 * pi * half(5).first_moment() - 8 * 16 * 49 * pi};
}

namespace {

// A disk of 10 with four bolts, against which a pipe ends.
TopoDS_Shape pipe_flange(gp_Pnt from, gp_Dir along, double radius) {
  return cylinder(from, along, radius, 10);
}

std::vector<TopoDS_Shape> bolts(gp_Pnt from, gp_Dir along, gp_Dir across, double circle) {
  std::vector<TopoDS_Shape> result;
  const gp_Vec u = gp_Vec(across) * (circle / std::sqrt(2.0)),
               v = gp_Vec(along.Crossed(across)) * (circle / std::sqrt(2.0));
  for (const auto& [a, b] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}})
    result.push_back(cylinder(from.Translated(u * a + v * b - gp_Vec(along)), along, 5, 12));
  return result;
}

// A quarter of a turn about the y axis through (60, 0, 0), from the z axis into x.
TopoDS_Shape bend(double radius, double before) {
  return BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(60, 0, before), gp::DY(), gp::DX().Reversed()), 60, radius,
                               pi / 2)
      .Shape();
}

TopoDS_Shape elbow_of_radius(double radius) {
  return joined({cylinder({0, 0, 0}, gp::DZ(), radius, 30), bend(radius, 30),
                 cylinder({60, 0, 90}, gp::DX(), radius, 30)});
}

}  // namespace

// Inside 40, outside 50, bent by 90 degrees about a radius of 60; flanges of 110.
Part pipe_elbow() {
  std::vector<TopoDS_Shape> tools = bolts({0, 0, 0}, gp::DZ(), gp::DX(), 40);
  for (const TopoDS_Shape& bolt : bolts({80, 0, 90}, gp::DX(), gp::DY(), 40)) tools.push_back(bolt);
  tools.push_back(elbow_of_radius(20));
  const TopoDS_Shape outside = joined(
      {elbow_of_radius(25), pipe_flange({0, 0, 0}, gp::DZ(), 55), pipe_flange({80, 0, 90}, gp::DX(), 55)});
  const double pipe = 225 * pi * (40 + 30 * pi), flanges = 2 * 10 * pi * (55 * 55 - 400 - 4 * 25);
  return {without(outside, tools),
          {{"lower flange", {0, 45, 0}}, {"upper flange", {90, 45, 90}}},
          pipe + flanges};
}

// A pipe of 60 (48 inside) along x, a branch of 40 (30 inside) with a flange of 90.
Part pipe_tee() {
  std::vector<TopoDS_Shape> tools = bolts({0, 0, 90}, gp::DZ(), gp::DX(), 33);
  tools.push_back(
      joined({cylinder({-101, 0, 0}, gp::DX(), 24, 202), cylinder({0, 0, 0}, gp::DZ(), 15, 101)}));
  const TopoDS_Shape outside =
      joined({cylinder({-100, 0, 0}, gp::DX(), 30, 200), cylinder({0, 0, 0}, gp::DZ(), 20, 100),
              pipe_flange({0, 0, 90}, gp::DZ(), 45)});
  return {without(outside, tools),
          {{"left end", {-100, 27, 0}}, {"branch flange", {40, 0, 100}}, {"right end", {100, 27, 0}}},
          {}};
}

}  // namespace isopatch::parts
