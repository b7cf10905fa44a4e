#include "geometry/brep/tests/made_solids/rounds.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <functional>

namespace {

TopoDS_Shape brick(double x, double y, double z, double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

TopoDS_Shape rod(double x, double y, double z, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp::DZ()), radius, height).Shape();
}

TopoDS_Shape fused_together(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  ShapeUpgrade_UnifySameDomain unify(BRepAlgoAPI_Fuse(a, b).Shape());
  unify.Build();
  return unify.Shape();
}

TopoDS_Shape less(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Cut(a, b).Shape();
}

// Edges of which all points satisfy a condition.
TopoDS_Shape rounded_where(const TopoDS_Shape& solid, double radius,
                           const std::function<bool(const gp_Pnt&)>& is_there) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(solid, TopAbs_EDGE, edges);
  BRepFilletAPI_MakeFillet fillet(solid);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges(i)));
    bool all = true;
    for (const double share : {0.0, 0.3, 0.6, 1.0})
      all =
          all && is_there(curve.Value((1 - share) * curve.FirstParameter() + share * curve.LastParameter()));
    if (all) fillet.Add(radius, TopoDS::Edge(edges(i)));
  }
  return fillet.Shape();
}

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-9;
}

// A boss on a plate, with a fillet of 2 around it.
TopoDS_Shape filleted_boss() {
  const TopoDS_Shape sharp = fused_together(brick(0, 0, 0, 30, 20, 10), rod(15, 10, 10, 5, 8));
  return rounded_where(sharp, 2, [](const gp_Pnt& p) {
    return is_near(p.Z(), 10) && is_near(std::hypot(p.X() - 15, p.Y() - 10), 5);
  });
}

// A square boss of round corners on a plate, with a round of 1 around its top.
TopoDS_Shape rounded_boss() {
  const TopoDS_Shape boss = rounded_where(brick(9, 5, 10, 12, 10, 8), 3, [](const gp_Pnt& p) {
    return (is_near(p.X(), 9) || is_near(p.X(), 21)) && (is_near(p.Y(), 5) || is_near(p.Y(), 15));
  });
  return rounded_where(fused_together(brick(0, 0, 0, 30, 20, 10), boss), 1,
                       [](const gp_Pnt& p) { return is_near(p.Z(), 18); });
}

// The same, sharp at its top's corners but round, with a fillet of 1 around its foot as well.
TopoDS_Shape rounded_boss_on_fillet() {
  return rounded_where(rounded_boss(), 1, [](const gp_Pnt& p) {
    return is_near(p.Z(), 10) && p.X() > 1 && p.X() < 29 && p.Y() > 1 && p.Y() < 19;
  });
}

// Round corners of 4, a bore; rounds of 1.5 around its top and its base, and around the bore's top.
TopoDS_Shape rounded_plate() {
  const TopoDS_Shape plate = rounded_where(brick(0, 0, 0, 30, 20, 8), 4, [](const gp_Pnt& p) {
    return (is_near(p.X(), 0) || is_near(p.X(), 30)) && (is_near(p.Y(), 0) || is_near(p.Y(), 20));
  });
  const auto is_bore = [](const gp_Pnt& p) { return is_near(std::hypot(p.X() - 15, p.Y() - 10), 4); };
  TopoDS_Shape solid = less(plate, rod(15, 10, -1, 4, 10));
  solid = rounded_where(solid, 1.5, [&](const gp_Pnt& p) { return is_near(p.Z(), 8) && is_bore(p); });
  return rounded_where(solid, 1.5, [](const gp_Pnt& p) {
    return (is_near(p.Z(), 8) || is_near(p.Z(), 0)) && std::hypot(p.X() - 15, p.Y() - 10) > 6;
  });
}

// A block with a bore from above; one edge of its top is round, from wall to wall.
TopoDS_Shape eased_block() {
  return rounded_where(less(brick(0, 0, 0, 30, 20, 10), rod(15, 12, -1, 4, 12)), 3,
                       [](const gp_Pnt& p) { return is_near(p.Y(), 0) && is_near(p.Z(), 10); });
}

// A step across the block with a fillet of 2, a blind hole from above with one of 1.5 on its floor, and one
// from below with one of 1 on its ceiling.
TopoDS_Shape filleted_step() {
  TopoDS_Shape solid = fused_together(brick(0, 0, 0, 32, 20, 10), brick(0, 0, 10, 13, 20, 8));
  solid = less(less(solid, rod(23, 10, 5, 5, 6)), rod(6, 10, -1, 4, 8));
  solid = rounded_where(solid, 2, [](const gp_Pnt& p) { return is_near(p.X(), 13) && is_near(p.Z(), 10); });
  solid = rounded_where(solid, 1.5, [](const gp_Pnt& p) { return is_near(p.Z(), 5); });
  return rounded_where(solid, 1, [](const gp_Pnt& p) { return is_near(p.Z(), 7); });
}

// A pocket with round corners of 4 and a fillet of 1.5 along all of its floor.
TopoDS_Shape filleted_pocket() {
  const TopoDS_Shape pocket = rounded_where(brick(6, 5, 5, 24, 12, 6), 4, [](const gp_Pnt& p) {
    return (is_near(p.X(), 6) || is_near(p.X(), 30)) && (is_near(p.Y(), 5) || is_near(p.Y(), 17));
  });
  return rounded_where(less(brick(0, 0, 0, 36, 22, 10), pocket), 1.5,
                       [](const gp_Pnt& p) { return is_near(p.Z(), 5); });
}

}  // namespace

std::map<std::string, TopoDS_Shape> rounds() {
  return {{"filleted_boss", filleted_boss()},
          {"rounded_boss", rounded_boss()},
          {"rounded_boss_on_fillet", rounded_boss_on_fillet()},
          {"rounded_plate", rounded_plate()},
          {"eased_block", eased_block()},
          {"filleted_step", filleted_step()},
          {"filleted_pocket", filleted_pocket()}};
}
