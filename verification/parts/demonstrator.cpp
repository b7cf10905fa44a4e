#include "verification/parts/internal/demonstrator.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Vec2d.hxx>
#include <numbers>

#include "verification/parts/internal/shapes.hpp"
#include "verification/parts/internal/splines.hpp"

namespace isopatch::parts {
namespace {

constexpr double top = 2.5, bottom = -27.437, pocket_floor = -20.2525;
constexpr double bore = 11.975, end_1 = 23.9495, end_2 = 35.9243, inner_round = 35.9243;
const gp_Pnt2d clamped(-10, -21.9495), loaded(181.5963, -147.6845), inner_centre(98.7109, -64.3356);

const double draft = std::tan(2.25 * std::numbers::pi / 180);
constexpr double measured_at = -25.5;  // where the pockets' outlines are given

gp_Pnt at(gp_Pnt2d p, double z) {
  return {p.X(), p.Y(), z};
}

TopoDS_Edge line(gp_Pnt2d from, gp_Pnt2d to, double z) {
  return BRepBuilderAPI_MakeEdge(at(from, z), at(to, z)).Edge();
}

TopoDS_Edge arc(gp_Pnt2d from, gp_Pnt2d to, gp_Pnt2d centre, double radius, double z, bool counterclockwise) {
  const gp_Dir axis = counterclockwise ? gp::DZ() : gp::DZ().Reversed();
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(at(centre, z), axis), radius), at(from, z), at(to, z)).Edge();
}

/// Where a line from a point touches a circle that lies to its right (side 1) or left (side -1).
gp_Pnt2d tangent_point(gp_Pnt2d from, gp_Pnt2d centre, double radius, int side) {
  const gp_Vec2d back(centre, from);
  const double cosine = radius / back.Magnitude();
  const gp_Vec2d unit = back.Normalized();
  return centre.Translated(unit * (radius * cosine) +
                           gp_Vec2d(unit.Y(), -unit.X()) * (side * radius * std::sqrt(1 - cosine * cosine)));
}

/// The outline at one height; the three freeform edges are given by the control points between their ends.
TopoDS_Wire outline(double z, const std::vector<gp_Pnt2d>& freeform) {
  const gp_Pnt2d start(clamped.X(), clamped.Y() + end_1), opposite(clamped.X(), clamped.Y() - end_1);
  const gp_Pnt2d round_begins = tangent_point(opposite, inner_centre, inner_round, 1);
  // The line between the inner round and end 2, of equal radii, crosses the middle of their centres.
  const gp_Pnt2d middle((inner_centre.X() + loaded.X()) / 2, (inner_centre.Y() + loaded.Y()) / 2);
  const gp_Pnt2d end_begins = tangent_point(middle, loaded, end_2, -1);
  const gp_Pnt2d round_ends = end_begins.Rotated(middle, std::numbers::pi);
  const gp_Pnt2d end_ends = loaded.Translated(gp_Vec2d(34.8177, 8.8475).Normalized() * end_2);
  const auto& f = freeform;
  return wire({arc(start, opposite, clamped, end_1, z, true), line(opposite, round_begins, z),
               arc(round_begins, round_ends, inner_centre, inner_round, z, false),
               line(round_ends, end_begins, z), arc(end_begins, end_ends, loaded, end_2, z, true),
               cubic({end_ends, f[0], f[1], f[2]}, z), cubic({f[2], f[3], f[4], f[5]}, z),
               cubic({f[5], f[6], f[7], start}, z)});
}

TopoDS_Shape pocket(const std::vector<gp_Pnt2d>& points, const std::vector<gp_Pnt2d>& cuts) {
  const auto outline_at = [&](double z) { return closed_spline(points, draft * (z - measured_at), z, cuts); };
  return ruled(outline_at(bottom - 1), outline_at(pocket_floor));
}

TopoDS_Shape pocket_a() {
  return pocket({{19.3, -4.3},  {2.6, -6.6},    {17, -18},     {7.4, -31.8}, {22.5, -34},
                 {33, -30.5},   {44.5, -27.3},  {55.6, -23.9}, {67, -20.9},  {78.5, -19.6},
                 {90.6, -18.4}, {100.2, -14.3}, {113.9, -4.4}, {99.2, 0.1},  {88.3, -1.3},
                 {76.5, -2.2},  {65, -4.1},     {53.3, -5.7},  {41.7, -6},   {29.6, -5.4}},
                {{8, -7}, {12, -31}, {97, -16}, {109, -4}});
}

TopoDS_Shape pocket_b() {
  return pocket(
      {{142.6, -44.8},  {143.2, -54.5},  {145.7, -64.5},  {148.1, -74.3},  {149.8, -84.3},  {150.6, -94.4},
       {151.2, -104.5}, {152.2, -114.6}, {152.5, -124.9}, {160.1, -133.8}, {168.4, -123.2}, {177.9, -122.7},
       {190.8, -124.9}, {190.3, -112.6}, {185.9, -103.9}, {181.5, -94.6},  {176.9, -85.6},  {172.6, -76.4},
       {168.4, -67.2},  {164.3, -58},    {159.9, -48.6},  {155.2, -40.4},  {149.9, -28.8},  {141.7, -33.1}},
      {{144, -31}, {154, -125}, {162, -130}, {190, -122}});
}

}  // namespace

Part demonstrator() {
  const TopoDS_Wire above = outline(top, {{199.52, -85.91},
                                          {189.99, -55.25},
                                          {175.816, -1.528},
                                          {171.59, 14.52},
                                          {150.42, 17.13},
                                          {141.43, 15.958},
                                          {61.24, 5.52},
                                          {40.34, 5.43}});
  const TopoDS_Wire below = outline(bottom, {{210.86, -123.28},
                                             {164.26, -30.05},
                                             {147.36, -0.342},
                                             {141.68, 9.65},
                                             {129.22, 14.72},
                                             {114.924, 13.187},
                                             {48.6, 6.1},
                                             {31.54, 4.41}});
  const auto drill = [](gp_Pnt2d centre) { return cylinder(at(centre, bottom - 1), gp::DZ(), bore, 40); };
  return {without(ruled(below, above), {drill(clamped), drill(loaded), pocket_a(), pocket_b()}),
          {{"clamped bore", {clamped.X() + bore, clamped.Y(), -10}},
           {"loaded bore", {loaded.X() + bore, loaded.Y(), -10}}},
          {}};
}

}  // namespace isopatch::parts
