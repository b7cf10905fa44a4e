#include "geometry/brep/tests/made_solids/turned.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Elips.hxx>
#include <gp_Vec.hxx>
#include <vector>

namespace {

const double half_turn = std::acos(-1.0);

TopoDS_Shape rod(const gp_Dir& along, double from, double radius, double length) {
  const gp_Pnt start(from * along.X(), from * along.Y(), from * along.Z());
  return BRepPrimAPI_MakeCylinder(gp_Ax2(start, along), radius, length).Shape();
}

TopoDS_Shape ball(const gp_Pnt& centre, double radius) {
  return BRepPrimAPI_MakeSphere(centre, radius).Shape();
}

TopoDS_Shape joined(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  ShapeUpgrade_UnifySameDomain unify(BRepAlgoAPI_Fuse(a, b).Shape());
  unify.Build();
  return unify.Shape();
}

TopoDS_Shape taken_off(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Cut(a, b).Shape();
}

TopoDS_Shape polygon_turned(const std::vector<gp_Pnt2d>& corners, double angle) {
  BRepBuilderAPI_MakePolygon outline;
  for (const gp_Pnt2d& corner : corners) outline.Add(gp_Pnt(corner.X(), 0, corner.Y()));
  outline.Close();
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp::OZ(), angle).Shape();
}

// A ring whose faces are in two halves, as some programs write all that goes around.
TopoDS_Shape ring_in_halves() {
  const TopoDS_Shape half = polygon_turned({{5, 0}, {9, 0}, {9, 2}, {7, 6}, {5, 6}}, half_turn);
  gp_Trsf around;
  around.SetRotation(gp::OZ(), half_turn);
  return BRepAlgoAPI_Fuse(half, half.Moved(TopLoc_Location(around))).Shape();
}

TopoDS_Shape with_round_circles(const TopoDS_Shape& solid, double rounding) {
  BRepFilletAPI_MakeFillet fillet(solid);
  for (TopExp_Explorer edges(solid, TopAbs_EDGE); edges.More(); edges.Next())
    if (BRep_Tool::IsClosed(edges.Current())) fillet.Add(rounding, TopoDS::Edge(edges.Current()));
  return fillet.Shape();
}

TopoDS_Shape bend(double distance, double radius, double angle) {
  return BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0.6, 0.8)), distance, radius, angle).Shape();
}

TopoDS_Edge quarter_ellipse(double radius, double height) {
  const gp_Elips ellipse(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, -1, 0), gp::DX()), radius, height);
  return BRepBuilderAPI_MakeEdge(ellipse, gp_Pnt(radius, 0, 0), gp_Pnt(0, 0, height)).Edge();
}

// The head of a vessel: between two halves of ellipsoids, as splines. (As surfaces of revolution the reader
// of STEP files loses their seams and takes them for planes.)
TopoDS_Shape vessel_head() {
  BRepBuilderAPI_MakeWire outline;
  outline.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(9, 0, 0), gp_Pnt(10, 0, 0)).Edge());
  outline.Add(quarter_ellipse(10, 5));
  outline.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 5), gp_Pnt(0, 0, 4)).Edge());
  outline.Add(quarter_ellipse(9, 4));
  const TopoDS_Face half = BRepBuilderAPI_MakeFace(outline.Wire()).Face();
  return BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeRevol(half, gp::OZ()).Shape(), true).Shape();
}

TopoDS_Shape prism(int sides, double across_corners, double from, double to) {
  BRepBuilderAPI_MakePolygon outline;
  for (int i = 0; i < sides; ++i) {
    const double angle = (2 * i + 0.5) * half_turn / sides;
    outline.Add(gp_Pnt(across_corners / 2 * std::cos(angle), across_corners / 2 * std::sin(angle), from));
  }
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, to - from))
      .Shape();
}

// A hexagonal socket in a head above a cone.
TopoDS_Shape socket_screw() {
  const TopoDS_Shape screw =
      polygon_turned({{0, 0}, {5, 0}, {5, 18}, {8, 21}, {8, 29}, {0, 29}}, 2 * half_turn);
  return taken_off(screw, prism(6, 8, 25, 30));
}

}  // namespace

std::map<std::string, TopoDS_Shape> turned_solids() {
  const TopoDS_Shape cup = rod(gp::DZ(), 0, 10, 20);
  const TopoDS_Shape dome = joined(rod(gp::DZ(), 0, 5, 20), ball({0, 0, 20}, 5));
  return {
      // The ball's own axis is z.
      {"ball_on_rod", joined(ball({10, 0, 0}, 6), rod(gp::DX(), -10, 3, 20))},
      {"bored_ball", taken_off(ball({0, 0, 0}, 8), rod(gp::DZ(), -10, 3, 20))},
      {"hollow_ball", taken_off(ball({0, 0, 0}, 8), ball({0, 0, 0}, 5))},
      {"domed_rod", dome},
      {"round_cup", taken_off(cup, joined(ball({0, 0, 12}, 6), rod(gp::DZ(), 12, 6, 10)))},
      {"flat_cup", taken_off(cup, rod(gp::DZ(), 8, 7, 15))},
      {"pointed_rod", joined(rod(gp::DZ(), 0, 5, 20),
                             BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, 0, 20), gp::DZ()), 5, 0, 5).Shape())},
      {"ring_in_halves", ring_in_halves()},
      {"sheave", polygon_turned({{4, 0},
                                 {8, 0},
                                 {8, 2},
                                 {20, 2},
                                 {20, 0},
                                 {25, 0},
                                 {25, 2},
                                 {21, 4},
                                 {21, 5},
                                 {25, 7},
                                 {25, 9},
                                 {20, 9},
                                 {20, 6},
                                 {8, 6},
                                 {8, 10},
                                 {4, 10}},
                                2 * half_turn)},
      {"round_ring",
       with_round_circles(polygon_turned({{10, 0}, {20, 0}, {20, 6}, {10, 6}}, 2 * half_turn), 1.5)},
      {"bent_rod", bend(12, 3, 2 * half_turn / 3)},
      {"bent_tube", taken_off(bend(12, 3, half_turn / 2), bend(12, 2, half_turn / 2))},
      {"vessel_head", vessel_head()},
      {"half_torus", bend(12, 3, half_turn)},
      {"half_shaft", polygon_turned({{0, 0}, {6, 0}, {6, 10}, {4, 10}, {4, 20}, {0, 20}}, half_turn)},
      {"quarter_shaft", polygon_turned({{0, 0}, {6, 0}, {4, 20}, {0, 20}}, half_turn / 2)},
      {"three_quarters", polygon_turned({{0, 0}, {6, 0}, {6, 10}, {0, 10}}, 1.5 * half_turn)},
      {"socket_screw", socket_screw()},
      {"square_end", joined(polygon_turned({{0, 0}, {6, 0}, {8, 4}, {8, 20}, {0, 20}}, 2 * half_turn),
                            prism(4, 12, 20, 30))},
      {"twelve_sided_hole",
       taken_off(polygon_turned({{0, 0}, {9, 0}, {7, 8}, {0, 8}}, 2 * half_turn), prism(12, 8, -1, 9))},
      {"odd_socket",
       taken_off(polygon_turned({{0, 0}, {9, 0}, {7, 8}, {0, 8}}, 2 * half_turn), prism(5, 8, -1, 9))},
      {"half_dome", taken_off(dome, BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -1), 20, 10, 30).Shape())},
  };
}
