#include "verification/parts/internal/drawn_later.hpp"

#include <cmath>
#include <numbers>

#include "verification/parts/internal/shapes.hpp"

namespace isopatch::parts {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

// A foot and a back of 10 with a gusset of 8 between two slots, two bores in the back.
Part gusset_bracket() {
  const Outline gusset = Outline::polygon({{10, 10}, {50, 10}, {10, 60}});
  const Outline slot = Outline::rectangle(24, 10, {26, 8}, 5),
                other = Outline::rectangle(24, 10, {26, 42}, 5);
  const TopoDS_Shape outside =
      joined({box({0, 0, 0}, {80, 60, 10}), box({0, 0, 10}, {10, 60, 70}), prism_along_y(gusset, 26, 34)});
  return {
      without(outside, {prism(slot, -1, 11), prism(other, -1, 11), cylinder({-1, 13, 45}, gp::DX(), 5, 12),
                        cylinder({-1, 47, 45}, gp::DX(), 5, 12)}),
      {{"base", {70, 30, 0}}, {"bore 1", {5, 18, 45}}, {"bore 2", {5, 52, 45}}},
      80 * 60 * 10 + 10 * 60 * 60 + 8 * gusset.area() - 2 * 10 * slot.area() - 2 * 10 * 25 * pi};
}

// Three bores that meet, one with a seat, four screws.
Part valve_block() {
  std::vector<TopoDS_Shape> tools = {
      cylinder({-1, 25, 25}, gp::DX(), 9, 72), cylinder({35, -1, 25}, gp::DY(), 7, 52),
      upright_cylinder(35, 25, 5, 25, 51), upright_cylinder(35, 25, 8, 44, 51)};
  for (const double x : {7.0, 63.0})
    for (const double y : {7.0, 43.0}) tools.push_back(upright_cylinder(x, y, 3.3, -1, 51));
  return {without(box({0, 0, 0}, {70, 50, 50}), tools),
          {{"base", {35, 25, 0}}, {"bore", {10, 25, 34}}, {"seat", {41.5, 25, 44}}},
          {}};
}

// A shaft of 30 with two flats, 22 across, and a hole of 8 through them.
Part shaft_end() {
  const TopoDS_Shape shaft =
      joined({upright_cylinder(0, 0, 15, 0, 60), cone({0, 0, 60}, gp::DZ(), 15, 14, 1)});
  return {without(shaft, {box({11, -16, 36}, {16, 16, 62}), box({-16, -16, 36}, {-11, 16, 62}),
                          cylinder({-12, 0, 48}, gp::DX(), 4, 24)}),
          {{"shaft", {1, 2, 0}}, {"hole", {9, 0, 52}}, {"flat", {11, 5, 40}}},
          {}};
}

// M16: a head of 24 across flats, turned to 30 degrees, and a shank with a chamfer.
Part hex_bolt() {
  const double fall = 3 * std::tan(pi / 6);
  const TopoDS_Shape blank =
      turned(Outline::polygon({{0, 0}, {14.5, 0}, {14.5, 10 - fall}, {11.5, 10}, {0, 10}}));
  const TopoDS_Shape head = common(prism(Outline::regular(6, 12), 0, 10), blank);
  return {
      joined({head, upright_cylinder(0, 0, 8, -40, 0), cone({0, 0, -40}, gp::DZ().Reversed(), 8, 6.5, 1.5)}),
      {{"seat", {0, 10, 0}}, {"end", {1, 2, -41.5}}, {"top", {1, 2, 10}}},
      {}};
}

// For a shaft of 30, closed by a screw across its slot.
Part split_clamp() {
  const Outline front = Outline({-15, 0})
                            .line_to({15, 0})
                            .line_to({15, 12})
                            .line_to({25, 12})
                            .line_to({25, 60})
                            .line_to({-25, 60})
                            .line_to({-25, 12})
                            .line_to({-15, 12})
                            .line_to({-15, 0});
  const TopoDS_Shape blank = prism_along_y(front, 0, 24);
  return {
      without(blank, {cylinder({0, -1, 36}, gp::DY(), 15, 26), box({-1.5, -1, -1}, {1.5, 25, 36}),
                      cylinder({-16, 12, 8}, gp::DX(), 3.3, 32), cylinder({11, 12, 8}, gp::DX(), 5.5, 5)}),
      {{"bore", {15, 12, 36}}, {"head", {11, 16.5, 8}}, {"top", {0, 12, 60}}},
      {}};
}

// Four screws with sunk heads, a groove for an O-ring below, a bore.
Part cover_plate() {
  const Outline plate = Outline::rectangle(100, 70, {-50, -35}, 10);
  std::vector<TopoDS_Shape> tools = {
      upright_cylinder(0, 0, 12, -1, 13),
      without(upright_cylinder(0, 0, 26, -1, 2.6), {upright_cylinder(0, 0, 22, -2, 3)})};
  for (const double x : {-40.0, 40.0})
    for (const double y : {-25.0, 25.0}) {
      tools.push_back(upright_cylinder(x, y, 3.3, -1, 13));
      tools.push_back(upright_cylinder(x, y, 5.5, 5.5, 13));
    }
  return {without(prism(plate, 0, 12), tools),
          {{"screw 1", {-36.7, -25, 3}}, {"top", {0, 20, 12}}, {"groove", {24, 0, 2.6}}},
          12 * plate.area() - 12 * 144 * pi - 2.6 * (676 - 484) * pi -
              4 * pi * (3.3 * 3.3 * 5.5 + 5.5 * 5.5 * 6.5)};
}

}  // namespace isopatch::parts
