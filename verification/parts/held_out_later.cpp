#include "verification/parts/internal/held_out_later.hpp"

#include <cmath>
#include <numbers>

#include "verification/parts/internal/shapes.hpp"

namespace isopatch::parts {
namespace {

constexpr double pi = std::numbers::pi;

bool lies_at(double a, double b) {
  return std::abs(a - b) < 1e-6;
}

/// A slot bent around the z axis: its middle at a radius, from an angle to another between its round ends.
Outline bent_slot(double radius, double width, double from, double to) {
  const auto at = [](double r, double angle) { return gp_Pnt2d(r * std::cos(angle), r * std::sin(angle)); };
  const double inner = radius - width / 2, outer = radius + width / 2;
  return Outline(at(outer, from))
      .arc_to(at(outer, to), {0, 0})
      .arc_to(at(inner, to), at(radius, to))
      .arc_to(at(inner, from), {0, 0}, false)
      .arc_to(at(outer, from), at(radius, from));
}

}  // namespace

// A bearing of 30 in an arch on two feet; from a flat above it a hole for grease, tapped at its beginning.
Part pillow_block() {
  const Outline front = Outline(gp_Pnt2d(-55, 0))
                            .line_to({55, 0})
                            .line_to({55, 12})
                            .line_to({25, 12})
                            .line_to({25, 35})
                            .arc_to({-25, 35}, {0, 35})
                            .line_to({-25, 12})
                            .line_to({-55, 12})
                            .line_to({-55, 0});
  const TopoDS_Shape blank = without(prism_along_y(front, -20, 20), {box({-30, -30, 58}, {30, 30, 70})});
  std::vector<TopoDS_Shape> tools = {cylinder({0, -21, 35}, gp::DY(), 15, 42),
                                     upright_cylinder(0, 0, 2, 40, 60), upright_cylinder(0, 0, 4, 52, 60)};
  for (const double x : {-40.0, 40.0}) tools.push_back(upright_cylinder(x, 0, 5.5, -1, 13));
  return {without(blank, tools), {{"base", {30, 15, 0}}, {"seat", {0, 15, 20}}, {"flat", {0, 15, 58}}}, {}};
}

// A disc of 120 with a pilot of 80, a bore, four bent slots to turn the motor in, four tapped blind holes.
Part pilot_flange() {
  const TopoDS_Shape blank =
      turned(Outline::polygon({{15, 0}, {60, 0}, {60, 10}, {40, 10}, {40, 14}, {15, 14}}));
  std::vector<TopoDS_Shape> tools;
  for (int i = 0; i < 4; ++i)
    tools.push_back(prism(bent_slot(50, 8, i * pi / 2 - 0.2, i * pi / 2 + 0.2), -1, 11));
  for (const gp_Pnt& place : on_circle(4, 28, 14, 0.125))
    tools.push_back(drilled(place, gp::DZ().Reversed(), 2.5, 9));
  return {without(blank, tools), {{"back", {20, 0, 0}}, {"pilot", {40, 0, 12}}, {"bore", {15, 0, 7}}}, {}};
}

// A collar, a groove inside with four holes from outside, chamfers.
Part radial_bushing() {
  const TopoDS_Shape blank = turned(Outline::polygon({{15, 0},
                                                      {29, 0},
                                                      {30, 1},
                                                      {30, 6},
                                                      {22, 6},
                                                      {22, 39},
                                                      {21, 40},
                                                      {15, 40},
                                                      {15, 27},
                                                      {17, 27},
                                                      {17, 20},
                                                      {15, 20}}));
  std::vector<TopoDS_Shape> tools;
  for (int i = 0; i < 4; ++i)
    tools.push_back(cylinder({0, 0, 23.5}, gp_Dir(std::cos(i * pi / 2), std::sin(i * pi / 2), 0), 2, 25));
  return {without(blank, tools), {{"collar", {25, 0, 0}}, {"bore", {0, 15, 10}}, {"end", {18, 0, 40}}}, {}};
}

// Sheet of 3, bent by 90 degrees with 4 inside: round corners, two holes and a slot.
Part bent_bracket() {
  const Outline side = Outline::polygon({{0, 0, 7}, {60, 0}, {60, 3}, {3, 3, 4}, {3, 50}, {0, 50}});
  const TopoDS_Shape sheet = rounded(prism_along_y(side, 0, 40), 6, [](const gp_Pnt& p) {
    return (lies_at(p.X(), 60) && lies_at(p.Z(), 1.5)) || (lies_at(p.X(), 1.5) && lies_at(p.Z(), 50));
  });
  const double area = side.area();
  return {without(sheet, {upright_cylinder(48, 10, 3.3, -1, 4), upright_cylinder(48, 30, 3.3, -1, 4),
                          prism(Outline::rectangle(16, 6, {16, 17}, 3), -1, 4),
                          cylinder({-1, 20, 36}, gp::DX(), 6, 5)}),
          {{"foot", {30, 5, 0}}, {"back", {0, 5, 30}}, {"hole", {1.5, 26, 36}}},
          40 * area - 3 * (4 * 36 * (1 - pi / 4) + 2 * 3.3 * 3.3 * pi + (60 + 9 * pi) + 36 * pi)};
}

// A hub with keyway below a plate; two arms with round ends and a cross' bores; fillets where they begin.
Part yoke() {
  const Outline front = Outline::polygon(
      {{-32, 0}, {32, 0}, {32, 70}, {20, 70}, {20, 14, 5}, {-20, 14, 5}, {-20, 70}, {-32, 70}});
  const TopoDS_Shape fork = rounded(prism_along_y(front, -18, 18), 17.9, [](const gp_Pnt& p) {
    return lies_at(p.Z(), 70) && lies_at(std::abs(p.Y()), 18) && std::abs(p.X()) > 20;
  });
  const TopoDS_Shape outside = joined({fork, upright_cylinder(0, 0, 17, -26, 1)});
  return {without(outside, {upright_cylinder(0, 0, 10, -27, 15), box({0, -3, -27}, {12.5, 3, 15}),
                            cylinder({-33, 0, 52}, gp::DX(), 8, 66)}),
          {{"hub", {0, 14, -26}}, {"left eye", {-26, 0, 44}}, {"right eye", {26, 0, 44}}},
          {}};
}

// Two flanges beside the teeth's cylinder, a hub; a keyway, and a hole for a set screw into it.
Part timing_pulley() {
  const TopoDS_Shape blank = turned(Outline::polygon({{8, 0},
                                                      {34, 0},
                                                      {34, 2},
                                                      {30, 2},
                                                      {30, 18},
                                                      {34, 18},
                                                      {34, 20},
                                                      {16, 20},
                                                      {16, 33},
                                                      {15, 34},
                                                      {8, 34}}));
  return {without(blank, {box({0, -2.5, -1}, {10.3, 2.5, 35}), cylinder({0, 0, 27}, gp::DX(), 2.1, 20)}),
          {{"bore", {-8, 0, 10}}, {"rim", {-30, 0, 10}}, {"side", {20, 0, 0}}},
          {}};
}

// A bore with its drill's tip, a sunk port from above and one from the front that end in it; four screws.
Part valve_body() {
  std::vector<TopoDS_Shape> tools = {drilled({-1, 25, 25}, gp::DX(), 9, 48),
                                     upright_cylinder(30, 25, 5, 25, 51), upright_cylinder(30, 25, 8, 40, 51),
                                     cylinder({18, -1, 25}, gp::DY(), 4, 26)};
  for (const double x : {7.0, 53.0})
    for (const double z : {7.0, 43.0}) tools.push_back(cylinder({x, -1, z}, gp::DY(), 3.3, 52));
  return {without(box({0, 0, 0}, {60, 50, 50}), tools),
          {{"base", {30, 25, 0}}, {"bore", {10, 25, 16}}, {"inlet", {0, 10, 25}}},
          {}};
}

// A ring with a slit; its screw goes across through a sunk hole on one side into the thread on the other.
Part clamp_collar() {
  const TopoDS_Shape ring = turned(Outline::polygon({{10, 0}, {20, 0}, {20, 12}, {10, 12}}));
  return {without(ring, {box({0, -1, -1}, {25, 1, 13}), cylinder({14.8, 0, 6}, gp::DY(), 2.2, 20),
                         cylinder({14.8, 0, 6}, gp::DY().Reversed(), 1.7, 20),
                         cylinder({14.8, 6, 6}, gp::DY(), 3.8, 20)}),
          {{"bore", {-10, 0, 6}}, {"outside", {-20, 0, 6}}, {"face", {-15, 0, 0}}},
          {}};
}

// Two eyes and the arm between them, hollowed from both sides to a web of 6 with round corners.
Part webbed_lever() {
  const TopoDS_Shape blank = prism(Outline::belt(20, 85, 12), -7, 7);
  const Outline pocket = Outline::polygon({{24, -12, 4}, {66, -7, 4}, {66, 7, 4}, {24, 12, 4}});
  const double holes = 14 * pi * (100 + 36), pockets = 8 * pocket.area();
  return {without(blank, {prism(pocket, 3, 8), prism(pocket, -8, -3), upright_cylinder(0, 0, 10, -8, 8),
                          upright_cylinder(85, 0, 6, -8, 8)}),
          {{"pivot", {10, 0, 0}}, {"eye", {91, 0, 0}}, {"web", {45, 0, 3}}},
          14 * Outline::belt(20, 85, 12).area() - pockets - holes};
}

// 35 x 7.5 of sheet of 1, bent with 0.8 inside, 100 long, three slots.
Part mounting_rail() {
  const Outline front = Outline::polygon({{-12.5, 0, 1.8},
                                          {12.5, 0, 1.8},
                                          {12.5, 6.5, 0.8},
                                          {17.5, 6.5},
                                          {17.5, 7.5},
                                          {11.5, 7.5, 1.8},
                                          {11.5, 1, 0.8},
                                          {-11.5, 1, 0.8},
                                          {-11.5, 7.5, 1.8},
                                          {-17.5, 7.5},
                                          {-17.5, 6.5},
                                          {-12.5, 6.5, 0.8}});
  std::vector<TopoDS_Shape> tools;
  for (const double y : {25.0, 50.0, 75.0})
    tools.push_back(prism(Outline::rectangle(6.2, 15, {-3.1, y - 7.5}, 3.1), -1, 2));
  const double slot = 6.2 * 8.8 + 3.1 * 3.1 * pi;
  return {without(prism_along_y(front, 0, 100), tools),
          {{"base", {8, 50, 0}}, {"left flange", {-15, 50, 7.5}}, {"right flange", {15, 50, 7.5}}},
          100 * front.area() - 3 * slot};
}

}  // namespace isopatch::parts
