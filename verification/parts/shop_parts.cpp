#include "verification/parts/internal/shop_parts.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "verification/parts/internal/shapes.hpp"

namespace isopatch::parts {
namespace {

constexpr double pi = std::numbers::pi;

/// What a keyway of half width w and depth d (from the axis) takes beyond a bore of radius r.
double keyway_area(double w, double d, double r) {
  return 2 * w * d - (w * std::sqrt(r * r - w * w) + r * r * std::asin(w / r));
}

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6;
}

}  // namespace

// A housing for a bearing of 40 on two feet.
Part bearing_block() {
  const Outline front = Outline::polygon(
      {{-60, 0}, {60, 0}, {60, 16, 4}, {32, 16, 6}, {32, 82, 32}, {-32, 82, 32}, {-32, 16, 6}, {-60, 16, 4}});
  const TopoDS_Shape blank = prism_along_y(front, 0, 40);
  return {without(blank, {cylinder({0, -1, 50}, gp::DY(), 20, 42), upright_cylinder(-47, 20, 5.5, -1, 17),
                          upright_cylinder(47, 20, 5.5, -1, 17)}),
          {{"base", {0, 20, 0}},
           {"bearing", {20, 20, 50}},
           {"bolt 1", {-41.5, 20, 8}},
           {"bolt 2", {52.5, 20, 8}}},
          40 * front.area() - 16000 * pi - 2 * 16 * 5.5 * 5.5 * pi};
}

// A fork for a pin of 20 on a rod of 28.
Part clevis() {
  const Outline side =
      Outline({0, -20}).line_to({50, -20}).arc_to({50, 20}, {50, 0}).line_to({0, 20}).line_to({0, -20});
  const Outline rod = Outline::polygon({{0, 0}, {14, 0}, {14, 48}, {12, 50}, {0, 50}});
  const TopoDS_Shape rod_along_x =
      joined({cylinder({-48, 0, 0}, gp::DX(), 14, 48), cone({-48, 0, 0}, gp::DX().Reversed(), 14, 12, 2)});
  const TopoDS_Shape outside = joined({prism_along_y(side, -20, 20), rod_along_x});
  const double behind_slot = 20 * 40;
  return {without(outside, {box({20, -8, -21}, {71, 8, 21}), cylinder({50, -21, 0}, gp::DY(), 10, 42)}),
          {{"rod", {-50, 1, 2}}, {"eye 1", {60, -14, 0}}, {"eye 2", {60, 14, 0}}},
          40 * side.area() - 16 * (side.area() - behind_slot) - 24 * 100 * pi + 2 * pi * rod.first_moment()};
}

// One leaf of a hinge: three knuckles for a pin of 6, three countersunk holes for screws of 5.
Part hinge_leaf() {
  const double meets = std::sqrt(36.0 - 4);
  const Outline leaf =
      Outline({0, 0}).line_to({50, 0}).line_to({50, 4}).line_to({meets, 4}).arc_to({0, 0}, {0, 6});
  std::vector<TopoDS_Shape> tools = {cylinder({0, -1, 6}, gp::DY(), 3, 82), box({-7, 16, -1}, {7, 32, 13}),
                                     box({-7, 48, -1}, {7, 64, 13})};
  for (const double y : {16.0, 40.0, 64.0}) {
    tools.push_back(upright_cylinder(32, y, 2.5, -1, 5));
    tools.push_back(cone({32, y, 4}, gp::DZ().Reversed(), 4.5, 2, 2.5));
  }
  const double hole = pi * (6.25 * 2 + 2 * (20.25 + 11.25 + 6.25) / 3);
  return {
      without(prism_along_y(leaf, 0, 80), tools),
      {{"back", {25, 30, 0}}, {"knuckle 1", {3, 8, 6}}, {"knuckle 2", {3, 40, 6}}, {"knuckle 3", {3, 72, 6}}},
      80 * leaf.area() - 48 * 9 * pi - 32 * (leaf.area() - 43 * 4) - 3 * hole};
}

// For a V-belt, with a web, four holes and a keyway of 6.
Part pulley() {
  const auto half = [](double fillet) {
    return Outline::polygon({{10, -15},
                             {18, -15},
                             {18, -4, fillet},
                             {42, -4, fillet},
                             {42, -10},
                             {52, -10},
                             {52, -7},
                             {45, -4},
                             {45, 4},
                             {52, 7},
                             {52, 10},
                             {42, 10},
                             {42, 4, fillet},
                             {18, 4, fillet},
                             {18, 15},
                             {10, 15}});
  };
  const TopoDS_Shape blank = rounded_at(turned(half(0)), 2, {{18, -4}, {42, -4}, {42, 4}, {18, 4}});
  std::vector<TopoDS_Shape> tools = {box({0, -3, -16}, {12.8, 3, 16})};
  for (const gp_Pnt& place : on_circle(4, 30, -5, 0.125))
    tools.push_back(upright_cylinder(place.X(), place.Y(), 7, -5, 5));
  return {without(blank, tools),
          {{"bore", {-10, 0, 0}}, {"groove", {45, 0, 0}}},
          2 * pi * half(2).first_moment() - 4 * 8 * 49 * pi - 30 * keyway_area(3, 12.8, 10)};
}

// For a slot of 10 and a thread M8.
Part t_slot_nut() {
  const Outline front = Outline::polygon(
      {{-7, 0}, {7, 0}, {9, 2}, {9, 7}, {4.9, 7}, {4.9, 12}, {-4.9, 12}, {-4.9, 7}, {-9, 7}, {-9, 2}});
  return {without(prism_along_y(front, 0, 18), {upright_cylinder(0, 9, 3.4, -1, 13)}),
          {{"left shoulder", {-7, 9, 7}}, {"thread", {3.4, 9, 6}}, {"right shoulder", {7, 9, 7}}},
          18 * front.area() - 12 * 3.4 * 3.4 * pi};
}

// Base circle 50, lift 15, flat flanks; bore of 20 with a keyway of 6.
Part cam() {
  const Outline belt = Outline::belt(25, 30, 10);
  return {without(prism(belt, 0, 15), {upright_cylinder(0, 0, 10, -1, 16), box({-12.8, -3, -1}, {0, 3, 16})}),
          {{"bore", {10, 0, 7}}, {"nose", {40, 0, 7}}},
          15 * (belt.area() - 100 * pi - keyway_area(3, 12.8, 10))};
}

// For a stepping motor: a stepped seat, four screws of the motor, four of the plate, two pockets.
Part motor_plate() {
  const Outline plate = Outline::rectangle(90, 90, {-45, -45}, 8),
                pocket = Outline::rectangle(10, 40, {29, -20}, 4);
  const Outline other = Outline::rectangle(10, 40, {-39, -20}, 4);
  std::vector<TopoDS_Shape> tools = {upright_cylinder(0, 0, 19, -1, 9), upright_cylinder(0, 0, 22, 5, 9),
                                     prism(pocket, 3, 9), prism(other, 3, 9)};
  std::vector<FaceName> names = {{"seat", {22, 0, 6.5}}, {"base", {0, -40, 0}}, {"pilot", {19, 0, 2}}};
  names.insert(names.begin(), {"screw 1", {40, 37, 4}});
  for (const auto& [x, y] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
    tools.push_back(upright_cylinder(23.57 * x, 23.57 * y, 2.6, -1, 9));
    tools.push_back(upright_cylinder(37 * x, 37 * y, 3, -1, 9));
  }
  return {without(prism(plate, 0, 8), tools), names,
          8 * plate.area() - 8 * 361 * pi - 3 * (484 - 361) * pi - 2 * 5 * pocket.area() -
              4 * 8 * (2.6 * 2.6 + 9) * pi};
}

// A bore through and two ports drilled into it, with their seats; four screws.
Part manifold_block() {
  std::vector<TopoDS_Shape> tools = {cylinder({-1, 30, 22}, gp::DX(), 8, 82)};
  for (const double x : {25.0, 55.0}) {
    tools.push_back(upright_cylinder(x, 30, 5, 22, 51));
    tools.push_back(upright_cylinder(x, 30, 9, 38, 51));
  }
  for (const double x : {8.0, 72.0})
    for (const double y : {8.0, 52.0}) tools.push_back(upright_cylinder(x, y, 3.5, -1, 51));
  return {
      without(box({0, 0, 0}, {80, 60, 50}), tools),
      {{"base", {40, 30, 0}}, {"gallery", {40, 22, 22}}, {"seat 1", {32, 30, 38}}, {"seat 2", {62, 30, 38}}},
      {}};
}

// Two hubs of different heights and an arm that tapers.
Part lever() {
  const gp_Pnt2d from(20 * std::cos(0.7), 20 * std::sin(0.7)),
      to(90 - 12 * std::cos(0.8), 12 * std::sin(0.8));
  const Outline arm = Outline({to.X(), -to.Y()})
                          .arc_to({to.X(), to.Y()}, {90, 0})
                          .line_to(from)
                          .arc_to({from.X(), -from.Y()}, {0, 0})
                          .line_to({to.X(), -to.Y()});
  const Outline web =
      Outline::polygon({{from.X(), -from.Y()}, {to.X(), -to.Y()}, {to.X(), to.Y()}, {from.X(), from.Y()}});
  const TopoDS_Shape outside =
      joined({prism(web, 0, 10), upright_cylinder(0, 0, 20, 0, 30), upright_cylinder(90, 0, 12, 0, 20)});
  return {without(outside, {upright_cylinder(0, 0, 10, -1, 31), upright_cylinder(90, 0, 6, -1, 21)}),
          {{"shaft", {10, 0, 20}}, {"pin", {96, 0, 10}}},
          10 * arm.area() + pi * (20 * 400 + 10 * 144 - 30 * 100 - 20 * 36)};
}

// Seats of 25 and 30, a collar, fillets and chamfers, a keyway of 8.
Part key_shaft() {
  const TopoDS_Shape sharp = turned(Outline::polygon({{0, 0},
                                                      {11.5, 0},
                                                      {12.5, 1},
                                                      {12.5, 30},
                                                      {15, 30},
                                                      {15, 70},
                                                      {18, 70},
                                                      {18, 80},
                                                      {15, 80},
                                                      {15, 109},
                                                      {14, 110},
                                                      {0, 110}}));
  const TopoDS_Shape shaft = rounded_at(rounded_at(sharp, 1.5, {{15, 70}, {15, 80}}), 1, {{12.5, 30}});
  const Outline key = Outline::rectangle(8, 22, {-4, 5}, 4);  // seen along y
  return {without(shaft, {prism_along_y(key, -20, -8.5)}),
          {{"left seat", {0, 12.5, 15}}, {"right end", {1, 2, 110}}, {"keyway", {0, -8.5, 16}}},
          {}};
}

// Nine fins on a plate with four holes.
Part heat_sink() {
  std::vector<Corner> front = {{0, 0}, {98, 0}};
  for (int fin = 8; fin >= 0; --fin) {
    const double x = 12.0 * fin;
    front.insert(front.end(), {{x + 2, 30}, {x, 30}});
    if (fin > 0) front.insert(front.end(), {{x, 6}, {x - 10, 6}});
  }
  const Outline outline = Outline::polygon(front);
  return {without(prism_along_y(outline, 0, 60),
                  {upright_cylinder(19, 10, 2, -1, 7), upright_cylinder(79, 10, 2, -1, 7),
                   upright_cylinder(19, 50, 2, -1, 7), upright_cylinder(79, 50, 2, -1, 7)}),
          {{"base", {49, 30, 0}}, {"fin 1", {1, 30, 30}}},
          60 * outline.area() - 4 * 6 * 4 * pi};
}

// Bent from a sheet of 3: two ears for a pin, a slot in the middle.
Part u_bracket() {
  const Outline front =
      Outline::polygon({{0, 0, 6}, {60, 0, 6}, {60, 45}, {57, 45}, {57, 3, 3}, {3, 3, 3}, {3, 45}, {0, 45}});
  const Outline slot = Outline::rectangle(20, 8, {20, 16}, 4);
  const TopoDS_Shape bent = rounded(prism_along_y(front, 0, 40), 12, [](const gp_Pnt& p) {
    return is_near(p.Z(), 45) && (is_near(p.Y(), 0) || is_near(p.Y(), 40));
  });
  return {without(bent, {cylinder({-1, 20, 30}, gp::DX(), 5, 62), prism(slot, -1, 4)}),
          {{"slot", {30, 16, 1.5}}, {"ear 1", {1.5, 25, 30}}, {"ear 2", {58.5, 25, 30}}},
          40 * front.area() - 4 * 3 * 144 * (1 - pi / 4) - 2 * 3 * 25 * pi - 3 * slot.area()};
}

}  // namespace isopatch::parts
