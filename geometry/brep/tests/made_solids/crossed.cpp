#include "geometry/brep/tests/made_solids/crossed.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>

namespace {

TopoDS_Shape plate(double x, double y, double z, double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

TopoDS_Shape pin(const gp_Pnt& from, const gp_Dir& along, double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(from, along), radius, length).Shape();
}

TopoDS_Shape joined(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  ShapeUpgrade_UnifySameDomain unify(BRepAlgoAPI_Fuse(a, b).Shape());
  unify.Build();
  return unify.Shape();
}

TopoDS_Shape without(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Cut(a, b).Shape();
}

TopoDS_Shape angle() {
  return joined(plate(0, 0, 0, 40, 30, 8), plate(0, 0, 0, 8, 30, 40));
}

// Its edges along y at x = z = at.
TopoDS_Shape rounded(const TopoDS_Shape& solid, double at, double radius) {
  BRepFilletAPI_MakeFillet fillet(solid);
  for (TopExp_Explorer it(solid, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge)), b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    const auto is_on = [&](const gp_Pnt& p) { return std::hypot(p.X() - at, p.Z() - at) < 1e-9; };
    if (is_on(a) && is_on(b)) fillet.Add(radius, edge);
  }
  return fillet.Shape();
}

TopoDS_Shape bored(const TopoDS_Shape& solid) {
  return without(without(solid, pin({26, 15, -1}, gp::DZ(), 5, 12)), pin({-1, 15, 28}, gp::DX(), 4, 12));
}

// A bend of a pipe about y, from the origin towards z, on a plate below.
TopoDS_Shape flanged_bend() {
  const auto bend = [](double radius) {
    return BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(15, 0, 0), gp::DY(), gp::DX().Reversed()), 15, radius,
                                 M_PI / 2)
        .Shape();
  };
  const TopoDS_Shape outside = joined(plate(-12, -8, -4, 24, 16, 4), bend(5));
  TopoDS_Shape result = without(without(outside, bend(3.5)), pin({0, 0, -5}, gp::DZ(), 3.5, 5));
  for (const double x : {-9.0, 9.0}) result = without(result, pin({x, 0, -5}, gp::DZ(), 1.5, 6));
  return result;
}

}  // namespace

std::map<std::string, TopoDS_Shape> crossed() {
  const TopoDS_Shape fork = without(plate(0, 0, 0, 40, 30, 30), plate(16, -1, 9, 30, 32, 12));
  const TopoDS_Shape lugs =
      joined(plate(0, 0, 0, 40, 30, 6), joined(plate(0, 4, 0, 12, 6, 24), plate(0, 20, 0, 12, 6, 24)));
  const TopoDS_Shape on_rod = without(
      joined(plate(0, 0, 0, 40, 30, 30), pin({-20, 15, 15}, gp::DX(), 11, 25)), plate(16, -1, 9, 30, 32, 12));
  // A nozzle beside the middle of a block's side, its bore ends in a slot.
  const TopoDS_Shape nozzle = joined(plate(0, 0, 0, 30, 40, 30), pin({-12, 15, 15}, gp::DX(), 8, 12));
  return {
      {"bored_rod_fork",
       without(without(on_rod, pin({30, 15, -1}, gp::DZ(), 5, 32)), pin({-21, 15, 15}, gp::DX(), 4, 40))},
      {"nozzle", without(without(nozzle, pin({-13, 15, 15}, gp::DX(), 4, 30)), plate(16, -1, 9, 10, 42, 12))},
      {"rod_fork", without(on_rod, pin({30, 15, -1}, gp::DZ(), 5, 32))},
      {"angle", bored(angle())},
      {"bent_sheet", bored(rounded(rounded(angle(), 0, 12), 8, 4))},
      {"fork",
       without(without(fork, pin({30, 15, -1}, gp::DZ(), 5, 32)), pin({-1, 15, 15}, gp::DX(), 4, 20))},
      {"flanged_bend", flanged_bend()},
      {"lugs", without(without(lugs, pin({26, 15, -1}, gp::DZ(), 5, 12)), pin({6, 0, 16}, gp::DY(), 3, 30))},
  };
}
