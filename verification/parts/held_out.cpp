#include "verification/parts/internal/held_out.hpp"

#include <BRepPrimAPI_MakeTorus.hxx>
#include <cmath>
#include <numbers>

#include "verification/parts/internal/shapes.hpp"

namespace isopatch::parts {
namespace {

constexpr double pi = std::numbers::pi;

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6;
}

/// A slot whose ends are half circles, along x, about a centre.
Outline slot_along_x(double length, double width, gp_Pnt2d centre) {
  return Outline::rectangle(length, width, {centre.X() - length / 2, centre.Y() - width / 2}, width / 2);
}

}  // namespace

// An angle of 8 with a fillet of 6: a foot with four slots, a back for a motor with a pilot of 38 and four
// screws.
Part motor_mount() {
  const Outline side = Outline::polygon({{0, 0}, {70, 0}, {70, 8}, {8, 8, 6}, {8, 80}, {0, 80}});
  const TopoDS_Shape sharp = prism_along_y(side, 0, 80);
  const TopoDS_Shape blank = rounded(sharp, 10, [](const gp_Pnt& p) {
    return (is_near(p.X(), 70) && is_near(p.Z(), 4) && (is_near(p.Y(), 0) || is_near(p.Y(), 80))) ||
           (is_near(p.X(), 4) && is_near(p.Z(), 80) && (is_near(p.Y(), 0) || is_near(p.Y(), 80)));
  });
  std::vector<TopoDS_Shape> tools = {cylinder({-1, 40, 46}, gp::DX(), 19, 10)};
  double slots = 0;
  for (const double x : {28.0, 54.0})
    for (const double y : {14.0, 66.0}) {
      const Outline slot = slot_along_x(16, 7, {x, y});
      tools.push_back(prism(slot, -1, 9));
      slots += 8 * slot.area();
    }
  for (const double y : {-1.0, 1.0})
    for (const double z : {-1.0, 1.0})
      tools.push_back(cylinder({-1, 40 + 23.57 * y, 46 + 23.57 * z}, gp::DX(), 2.6, 10));
  return {without(blank, tools),
          {{"base", {40, 40, 0}}, {"pilot", {4, 59, 46}}, {"back", {0, 4, 60}}},
          80 * side.area() - 4 * 8 * 100 * (1 - pi / 4) - slots - 8 * pi * (361 + 4 * 2.6 * 2.6)};
}

// Two legs of 10 and 60 wide, their corners rounded, a gusset of 6 at each side, two bores in each.
Part angle_bracket() {
  const Outline angle = Outline::polygon({{0, 0}, {70, 0}, {70, 10}, {10, 10}, {10, 90}, {0, 90}});
  const Outline gusset = Outline::polygon({{10, 10}, {45, 10}, {10, 60}});
  const TopoDS_Shape legs = rounded(prism_along_y(angle, 0, 60), 8, [](const gp_Pnt& p) {
    return (is_near(p.X(), 70) && is_near(p.Z(), 5)) || (is_near(p.X(), 5) && is_near(p.Z(), 90));
  });
  const TopoDS_Shape outside = joined({legs, prism_along_y(gusset, 0, 6), prism_along_y(gusset, 54, 60)});
  return {without(outside,
                  {upright_cylinder(54, 18, 4.5, -1, 11), upright_cylinder(54, 42, 4.5, -1, 11),
                   cylinder({-1, 18, 72}, gp::DX(), 4.5, 12), cylinder({-1, 42, 72}, gp::DX(), 4.5, 12)}),
          {{"wall", {0, 30, 40}}, {"bore 1", {58.5, 18, 5}}, {"bore 2", {58.5, 42, 5}}},
          60 * angle.area() + 12 * gusset.area() - 4 * 10 * 64 * (1 - pi / 4) - 4 * 10 * 4.5 * 4.5 * pi};
}

// The lower half of a housing for a bearing of 52: a seat with a groove, two feet with slots, two bolts for
// the cap.
Part split_housing() {
  const Outline front = Outline::polygon(
      {{-80, 0}, {80, 0}, {80, 14, 3}, {50, 14, 8}, {50, 45}, {-50, 45}, {-50, 14, 8}, {-80, 14, 3}});
  const TopoDS_Shape blank = prism_along_y(front, -25, 25);
  std::vector<TopoDS_Shape> tools = {cylinder({0, -26, 45}, gp::DY(), 24, 52),
                                     cylinder({0, -16, 45}, gp::DY(), 26, 32)};
  double slots = 0;
  for (const double x : {-66.0, 66.0}) {
    const Outline slot = slot_along_x(14, 9, {x, 0});
    tools.push_back(prism(slot, -1, 15));
    slots += 14 * slot.area();
  }
  for (const double x : {-38.0, 38.0}) tools.push_back(upright_cylinder(x, 0, 4.3, 15, 46));
  return {without(blank, tools),
          {{"base", {0, 20, 0}}, {"seat", {0, 1, 19}}, {"parting", {45, 15, 45}}},
          50 * front.area() - pi / 2 * (32 * 676 + 18 * 576) - slots - 2 * 30 * 4.3 * 4.3 * pi};
}

// Two arms of 8 at right angles, with a fillet of 12 between them; three hubs of different heights.
Part bell_crank() {
  const Outline arms = Outline::polygon({{-8, -8}, {60, -8}, {60, 8}, {8, 8, 12}, {8, 45}, {-8, 45}});
  const TopoDS_Shape outside =
      joined({prism(arms, 0, 8), upright_cylinder(0, 0, 16, 0, 24), upright_cylinder(60, 0, 11, 0, 16),
              upright_cylinder(0, 45, 11, -4, 12)});
  return {without(outside, {upright_cylinder(0, 0, 9, -1, 25), upright_cylinder(60, 0, 5, -1, 17),
                            upright_cylinder(0, 45, 5, -5, 13)}),
          {{"pivot", {9, 0, 12}}, {"long eye", {65, 0, 8}}, {"short eye", {5, 45, 4}}},
          {}};
}

// DN 50: a neck that tapers to the pipe, its fillet, a raised face, four bolts of 18.
Part weld_neck_flange() {
  const Outline half = Outline::polygon(
      {{27, 0}, {51, 0}, {51, 3}, {82.5, 3}, {82.5, 20}, {37.5, 20}, {30.5, 36}, {30.5, 48}, {27, 48}});
  const TopoDS_Shape blank = rounded_at(turned(half), 6, {{37.5, 20}});
  std::vector<TopoDS_Shape> tools;
  for (const gp_Pnt& place : on_circle(4, 62.5, 0, 0.125))
    tools.push_back(upright_cylinder(place.X(), place.Y(), 9, -1, 21));
  return {without(blank, tools),
          {{"raised face", {40, 1, 0}}, {"pipe end", {28, 1, 48}}, {"bore", {27, 0, 20}}},
          {}};
}

// A hub with a keyway of 8, a web with six holes, a rim with chamfers.
Part gear_blank() {
  const Outline half = Outline::polygon({{14, -20},
                                         {26, -20},
                                         {26, -5},
                                         {58, -5},
                                         {58, -14},
                                         {69, -14},
                                         {70, -13},
                                         {70, 13},
                                         {69, 14},
                                         {58, 14},
                                         {58, 5},
                                         {26, 5},
                                         {26, 20},
                                         {14, 20}});
  std::vector<TopoDS_Shape> tools = {box({0, -4, -21}, {17.3, 4, 21})};
  for (const gp_Pnt& place : on_circle(6, 42, 0, 1 / 12.0))
    tools.push_back(upright_cylinder(place.X(), place.Y(), 9, -6, 6));
  const double segment =
      14 * 14 * std::asin(4 / 14.0) + 4 * std::sqrt(14 * 14 - 16.0);  // of the bore, 8 wide
  return {without(turned(half), tools),
          {{"bore", {-14, 0, 0}}, {"rim", {-70, 0, 0}}, {"hub", {0, 20, 20}}},
          2 * pi * half.first_moment() - 6 * 10 * 81 * pi - 40 * (2 * 4 * 17.3 - segment)};
}

// Three drilled bores that meet, of 14, 10 and 8, all but one with their drill's tip; two ports, two screws.
Part hydraulic_block() {
  return {without(box({0, 0, 0}, {90, 60, 50}),
                  {drilled({-1, 30, 25}, gp::DX(), 7, 76), cylinder({-1, 30, 25}, gp::DX(), 11, 13),
                   drilled({30, -1, 25}, gp::DY(), 5, 31), drilled({60, 30, 51}, gp::DZ().Reversed(), 4, 26),
                   upright_cylinder(60, 30, 8, 39, 51), upright_cylinder(82, 10, 4.3, -1, 51),
                   upright_cylinder(82, 50, 4.3, -1, 51)}),
          {{"base", {45, 30, 0}}, {"gallery", {45, 30, 18}}, {"port", {-0.0, 50, 25}}},
          {}};
}

// A fork of 16 x 16 with round corners at its end, for a pin of 8; a shank with a thread that runs into the
// slot.
Part rod_end() {
  const TopoDS_Shape fork = rounded(box({0, -8, -8}, {32, 8, 8}), 4, [](const gp_Pnt& p) {
    return is_near(p.X(), 32) && is_near(p.Y(), 0) && (is_near(p.Z(), 8) || is_near(p.Z(), -8));
  });
  return {without(joined({fork, cylinder({-20, 0, 0}, gp::DX(), 7, 20)}),
                  {box({8, -4, -9}, {33, 4, 9}), cylinder({24, -9, 0}, gp::DY(), 4, 18),
                   cylinder({-21, 0, 0}, gp::DX(), 3.4, 30)}),
          {{"shank end", {-20, 5, 0}}, {"eye 1", {28, -6, 0}}, {"eye 2", {28, 6, 0}}},
          16 * (16 * 32 - 2 * 16 * (1 - pi / 4)) + 20 * 49 * pi - 8 * (16 * 24 - 2 * 16 * (1 - pi / 4)) -
              8 * 16 * pi - 28 * 3.4 * 3.4 * pi};
}

// A vee of 90 degrees with its relief, a slot along each side for the clamp, two bores down through the
// slots.
Part vee_block() {
  const Outline front = Outline::polygon({{-30, 0},
                                          {30, 0},
                                          {30, 14},
                                          {20, 14},
                                          {20, 22},
                                          {30, 22},
                                          {30, 50},
                                          {26, 50},
                                          {2, 26},
                                          {2, 20},
                                          {-2, 20},
                                          {-2, 26},
                                          {-26, 50},
                                          {-30, 50},
                                          {-30, 22},
                                          {-20, 22},
                                          {-20, 14},
                                          {-30, 14}});
  return {without(prism_along_y(front, 0, 50),
                  {upright_cylinder(-25, 25, 2.5, -1, 15), upright_cylinder(25, 25, 2.5, -1, 15)}),
          {{"base", {0, 25, 0}}, {"left flank", {-14, 25, 38}}, {"right flank", {14, 25, 38}}},
          50 * front.area() - 2 * 14 * 6.25 * pi};
}

// Two screws with sunk heads; a vee along the face and one across it, for round bars; a step above.
Part vise_jaw() {
  const Outline side = Outline::polygon(
      {{0, 0}, {16, 0}, {16, 14}, {10, 20}, {16, 26}, {16, 36}, {12, 36}, {12, 40}, {0, 40}});
  const Outline vee = Outline::polygon({{8, 50}, {16, 42}, {17, 42}, {17, 58}, {16, 58}});
  std::vector<TopoDS_Shape> tools = {prism(vee, -1, 41)};
  for (const double y : {20.0, 80.0}) {
    tools.push_back(cylinder({-1, y, 20}, gp::DX(), 4.5, 18));
    tools.push_back(cylinder({7, y, 20}, gp::DX(), 7.5, 10));
  }
  const TopoDS_Shape blank = prism_along_y(side, 0, 100);
  return {without(blank, tools), {{"back", {0, 50, 20}}, {"face", {16, 5, 7}}, {"step", {12, 5, 38}}}, {}};
}

// M10: a head of 16 with a chamfer and a socket of 8, a shank with a chamfer, a fillet below the head.
Part cap_screw() {
  const TopoDS_Shape sharp =
      turned(Outline::polygon({{0, 0}, {4, 0}, {5, 1}, {5, 40}, {8, 40}, {8, 49}, {7, 50}, {0, 50}}));
  return {without(rounded_at(sharp, 0.6, {{5, 40}}), {prism(Outline::regular(6, 4), 45, 51)}),
          {{"seat", {7, 0, 40}}, {"end", {1, 2, 0}}, {"socket", {1, 1, 45}}},
          {}};
}

// Seats of 20, 25 and 30, a groove for a ring, a keyway of 6, a hole of 6 across, fillets and chamfers.
Part spindle() {
  const TopoDS_Shape sharp = turned(Outline::polygon({{0, 0},
                                                      {9, 0},
                                                      {10, 1},
                                                      {10, 6},
                                                      {9.25, 6},
                                                      {9.25, 7.5},
                                                      {10, 7.5},
                                                      {10, 35},
                                                      {12.5, 35},
                                                      {12.5, 75},
                                                      {15, 75},
                                                      {15, 120},
                                                      {14, 121},
                                                      {0, 121}}));
  const TopoDS_Shape shaft = rounded_at(sharp, 1, {{10, 35}, {12.5, 75}});
  const Outline key = Outline::rectangle(6, 20, {-3, 45}, 3);  // seen along y
  return {without(shaft, {prism_along_y(key, -20, -9), cylinder({-16, 0, 100}, gp::DX(), 3, 32)}),
          {{"left seat", {0, 10, 20}}, {"right end", {1, 2, 121}}, {"hole", {8, 0, 103}}},
          {}};
}

// 80 x 45 with round inner corners, 6 and 8 thick: three bores in each flange, two slots in the web.
Part u_channel() {
  const Outline front =
      Outline::polygon({{0, 0}, {80, 0}, {80, 45}, {72, 45}, {72, 6, 8}, {8, 6, 8}, {8, 45}, {0, 45}});
  std::vector<TopoDS_Shape> tools;
  for (const double y : {20.0, 70.0, 120.0}) tools.push_back(cylinder({-1, y, 30}, gp::DX(), 5.5, 82));
  double slots = 0;
  for (const double y : {45.0, 95.0}) {
    const Outline slot = slot_along_x(30, 11, {40, y});
    tools.push_back(prism(slot, -1, 7));
    slots += 6 * slot.area();
  }
  return {without(prism_along_y(front, 0, 140), tools),
          {{"left end", {4, 0, 30}}, {"slot 1", {40, 50.5, 3}}, {"base", {40, 10, 0}}},
          140 * front.area() - 6 * 8 * 5.5 * 5.5 * pi - slots};
}

// A plate with round corners and a round upper rim, six screws, a rim below and a groove for a cord around
// it.
Part lid() {
  const Outline plate = Outline::rectangle(120, 80, {-60, -40}, 10);
  const Outline rim = Outline::rectangle(88, 48, {-44, -24}, 6),
                inside = Outline::rectangle(80, 40, {-40, -20}, 2);
  const Outline groove = Outline::rectangle(100, 60, {-50, -30}, 9),
                island = Outline::rectangle(92, 52, {-46, -26}, 5);
  const TopoDS_Shape top =
      rounded(prism(plate, 0, 10), 2, [](const gp_Pnt& p) { return is_near(p.Z(), 10); });
  std::vector<TopoDS_Shape> tools = {prism(inside, -7, 0),
                                     without(prism(groove, -1, 2.5), {prism(island, -2, 3)})};
  for (const auto& [x, y] : {std::pair{52, 32}, {0, 34}, {-52, 32}, {-52, -32}, {0, -34}, {52, -32}})
    tools.push_back(upright_cylinder(x, y, 2.7, -1, 11));
  return {without(joined({top, prism(rim, -6, 0)}), tools),
          {{"sealing face", {57, 0, 0}}, {"top", {0, 0, 10}}, {"rim", {42, 0, -6}}},
          {}};
}

// M16: a ring of 14 about a circle of 44 on a collar, a shank.
Part eye_bolt() {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(0, 0, 32), gp::DY()), 22, 7).Shape();
  return {joined({ring, cone({0, 0, 0}, gp::DZ(), 17, 11, 10), upright_cylinder(0, 0, 8, -30, 0)}),
          {{"shank end", {1, 2, -30}}, {"seat", {12, 0, 0}}, {"collar", {0, -14, 5}}},
          {}};
}

// A lever with a boss about its pivot, a slot bent around it, two threads; its upper edge is round.
Part swing_plate() {
  const Outline outline = Outline::belt(20, 70, 32);
  const auto at = [](double radius, double angle) {
    return gp_Pnt2d(radius * std::cos(angle), radius * std::sin(angle));
  };
  const double half = 0.3;
  const Outline slot = Outline(at(76, -half))
                           .arc_to(at(76, half), {0, 0})
                           .arc_to(at(68, half), at(72, half))
                           .arc_to(at(68, -half), {0, 0}, false)
                           .arc_to(at(76, -half), at(72, -half));
  const TopoDS_Shape plate =
      rounded(prism(outline, 0, 10), 2, [](const gp_Pnt& p) { return is_near(p.Z(), 10); });
  return {without(joined({plate, upright_cylinder(0, 0, 14, 0, 22)}),
                  {upright_cylinder(0, 0, 8, -1, 23), prism(slot, -1, 11),
                   upright_cylinder(92, 0, 2.5, -1, 11), upright_cylinder(42, 0, 4, -1, 11)}),
          {{"pivot", {8, 0, 10}}, {"slot", {76, 0, 5}}, {"base", {30, 0, 0}}},
          {}};
}

}  // namespace isopatch::parts
