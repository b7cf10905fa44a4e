#include "verification/parts/internal/turned_parts.hpp"

#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <cmath>
#include <numbers>

#include "verification/parts/internal/shapes.hpp"

namespace isopatch::parts {
namespace {

constexpr double pi = std::numbers::pi;

// A round bar from the plane of x and z, bent about the y axis through (distance, 0, 0).
TopoDS_Shape bend(double distance, double radius, double angle) {
  return BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(distance, 0, 0), gp::DY(), gp::DX().Reversed()), distance,
                               radius, angle)
      .Shape();
}

}  // namespace

// A ball of 22 on a neck of 12, a cone and a shank of 12.
Part ball_stud() {
  const double meets = 44 - std::sqrt(11.0 * 11 - 36);
  const Outline half = Outline({0, -20})
                           .line_to({6, -20})
                           .line_to({6, 0})
                           .line_to({9, 0})
                           .line_to({6, 24})
                           .line_to({6, meets})
                           .arc_to({0, 55}, {0, 44})
                           .line_to({0, -20});
  return {
      joined({cylinder({0, 0, -20}, gp::DZ(), 6, 20), cone({0, 0, 0}, gp::DZ(), 9, 6, 24),
              cylinder({0, 0, 24}, gp::DZ(), 6, 15), BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 44), 11).Shape()}),
      {{"shank", {0, 6, -10}}, {"ball", {0, 11, 44}}},
      2 * pi * half.first_moment()};
}

// A tenon, a collar, a waist, a belly and a round end.
Part turned_handle() {
  const Outline half = Outline({0, 0})
                           .line_to({5, 0})
                           .line_to({5, 15})
                           .line_to({9, 15})
                           .line_to({9, 19})
                           .arc_to({9, 45}, {25, 32}, false)
                           .arc_to({9, 73}, {-27, 59})
                           .arc_to({0, 82}, {0, 73})
                           .line_to({0, 0});
  return {turned(half),
          {{"tenon", {0, 5, 7}}, {"end", {0, 0, 82}}, {"collar", {0, 9, 17}}},
          2 * pi * half.first_moment()};
}

// Two sections with a fillet between them; the edges of both are round.
Part rounded_shaft() {
  const auto half = [](double fillet, double edge) {
    return Outline::polygon(
        {{0, 0}, {20, 0, edge}, {20, 40, edge}, {12, 40, fillet}, {12, 100, edge}, {0, 100}});
  };
  const TopoDS_Shape filleted = rounded_at(turned(half(0, 0)), 3, {{12, 40}});
  return {rounded_at(filleted, 2, {{20, 0}, {20, 40}, {12, 100}}),
          {{"left end", {1, 2, 0}}, {"right end", {1, 2, 100}}},
          2 * pi * half(3, 2).first_moment()};
}

// All four edges are round.
Part rounded_washer() {
  const auto half = [](double edge) { return Outline::rectangle(10, 6, {10, 0}, edge); };
  return {rounded_at(turned(half(0)), 2, {{10, 0}, {20, 0}, {20, 6}, {10, 6}}),
          {{"base", {15, 0, 0}}, {"top", {15, 0, 6}}, {"bore", {0, 10, 3}}},
          2 * pi * half(2).first_moment()};
}

// Inside 40, outside 50, by 90 degrees about a radius of 60.
Part bent_pipe() {
  return {without(bend(60, 25, pi / 2), {bend(60, 20, pi / 2)}),
          {{"lower end", {0, 22.5, 0}},
           {"upper end", {60, 22.5, 60}},
           {"outside", {60 - 85 * std::sqrt(0.5), 0, 85 * std::sqrt(0.5)}}},
          225 * pi * 30 * pi};
}

// A bar of 20, by 120 degrees about a radius of 40.
Part bent_bar() {
  return {bend(40, 10, 2 * pi / 3),
          {{"lower end", {1, 2, 0}}, {"upper end", {60, 2, 20 * std::sqrt(3.0)}}},
          100 * pi * 80 * pi / 3};
}

// Of a hollow ball of radii 10 and 20.
Part shell_octant() {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(20.0, 0.0, pi / 2, pi / 2).Shape();
  const double inner = 10 / std::sqrt(3.0), outer = 20 / std::sqrt(3.0);
  return {without(ball, {BRepPrimAPI_MakeSphere(10.0).Shape()}),
          {{"x0", {0, 10, 11}},
           {"inside", {inner, inner, inner}},
           {"y0", {10, 0, 11}},
           {"z0", {10, 11, 0}},
           {"outside", {outer, outer, outer}}},
          pi * 7000 / 6};
}

}  // namespace isopatch::parts
