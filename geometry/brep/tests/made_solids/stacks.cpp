#include "geometry/brep/tests/made_solids/stacks.hpp"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS.hxx>
#include <utility>

namespace {

TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

TopoDS_Shape cylinder(double x, double y, double z, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp::DZ()), radius, height).Shape();
}

TopoDS_Shape cone(double x, double y, double z, double low, double high, double height) {
  return BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(x, y, z), gp::DZ()), low, high, height).Shape();
}

TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  ShapeUpgrade_UnifySameDomain unify(BRepAlgoAPI_Fuse(a, b).Shape());
  unify.Build();
  return unify.Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Cut(a, b).Shape();
}

// A trapezoid, wider above by 3 on each side over 6, in the planes of x and z or of y and z.
TopoDS_Shape trapezoid(bool in_x, double from, double width, double z) {
  BRepBuilderAPI_MakePolygon outline;
  const auto add = [&](double along, double height) {
    outline.Add(in_x ? gp_Pnt(along, -100, height) : gp_Pnt(-100, along, height));
  };
  add(from, z);
  add(from + width, z);
  add(from + width + 3, z + 6);
  add(from - 3, z + 6);
  outline.Close();
  const gp_Vec along = in_x ? gp_Vec(0, 200, 0) : gp_Vec(200, 0, 0);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), along).Shape();
}

TopoDS_Shape drafted(double x, double y, double z, double dx, double dy) {
  return BRepAlgoAPI_Common(trapezoid(true, x, dx, z), trapezoid(false, y, dy, z)).Shape();
}

// A square of 20 with a bore of 8, its upper corners turned off by a cone.
TopoDS_Shape turned_off() {
  const TopoDS_Shape blank = cut(box(-10, -10, 0, 20, 20, 12), cylinder(0, 0, -1, 4, 14));
  return BRepAlgoAPI_Common(blank, fused(cylinder(0, 0, 0, 15, 9), cone(0, 0, 9, 15, 9, 3))).Shape();
}

// A rectangle whose upper side is a spline.
TopoDS_Shape wavy() {
  TColgp_Array1OfPnt points(1, 5);
  const double heights[] = {12, 16, 13, 11, 14};
  for (int i = 0; i < 5; ++i) points.SetValue(i + 1, gp_Pnt(8 * i, heights[i], 0));
  BRepBuilderAPI_MakeWire outline;
  outline.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(32, 0, 0)).Edge());
  outline.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(32, 0, 0), gp_Pnt(32, 14, 0)).Edge());
  outline.Add(BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve()).Edge());
  outline.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 12, 0), gp_Pnt(0, 0, 0)).Edge());
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 6)).Shape();
}

// A bored disc of 40 with four blind holes whose tips end in flats.
TopoDS_Shape tipped_cover() {
  TopoDS_Shape result = cut(cylinder(0, 0, 0, 40, 12), cylinder(0, 0, -1, 12, 14));
  for (const auto& [x, y] : {std::pair(26, 0), {0, 26}, {-26, 0}, {0, -26}})
    result = cut(cut(result, cylinder(x, y, 5, 4, 8)), cone(x, y, 3, 1, 4, 2));
  return result;
}

}  // namespace

std::map<std::string, TopoDS_Shape> stacks() {
  const TopoDS_Shape block = box(0, 0, 0, 30, 20, 10);
  const TopoDS_Shape shaft = fused(fused(cylinder(0, 0, 0, 5, 12), cone(0, 0, 12, 5, 8, 4)),
                                   fused(cylinder(0, 0, 16, 8, 8), cylinder(0, 0, 24, 11, 6)));
  const TopoDS_Shape boss = fused(block, cylinder(15, 10, 10, 6, 5));
  return {
      {"tipped_cover", tipped_cover()},
      {"cusp", cut(box(0, 0, 0, 10, 10, 5), cylinder(0, 10, -1, 10, 7))},
      {"countersunk", cut(cut(block, cylinder(15, 10, -1, 5, 12)), cone(15, 10, 7, 5, 8, 3))},
      {"drafted_pocket", cut(block, drafted(9, 7, 4, 12, 6))},
      {"drafted_boss", fused(block, drafted(9, 7, 10, 12, 6))},
      {"shaft", shaft},
      {"bored_boss", cut(boss, cylinder(15, 10, -1, 3, 17))},
      // A bore in the strip between a pocket and the edge, near to both, and one at the pocket's end.
      {"bored_beside_a_pocket",
       cut(cut(cut(box(0, 0, 0, 80, 40, 10), box(10, 26, 7, 70, 4, 4)), cylinder(60, 35, -1, 3.5, 12)),
           cylinder(8, 34, -1, 2.7, 12))},
      {"pocketed", cut(block, box(5, 5, 6, 20, 10, 5))},
      {"turned_off", turned_off()},
      {"wavy", cut(wavy(), cylinder(16, 6, -1, 3, 8))},
  };
}
