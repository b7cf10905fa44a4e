#include "geometry/brep/tests/made_solids/slotted.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

constexpr double length = 60, middle = 20, height = 24;  // along x, y of the plane of symmetry, along z

TopoDS_Shape cut(const TopoDS_Shape& shape, const TopoDS_Shape& tool) {
  return BRepAlgoAPI_Cut(shape, tool).Shape();
}

TopoDS_Shape pin_hole(const TopoDS_Shape& shape) {
  return cut(shape, BRepPrimAPI_MakeCylinder(gp_Ax2({51, middle, -1}, gp::DZ()), 4, height + 2).Shape());
}

/// Between two edges along x and their ends.
TopoDS_Shape between(const TopoDS_Edge& low, const TopoDS_Edge& high, double half, double other_half) {
  BRepBuilderAPI_MakeWire outline;
  outline.Add(low);
  outline.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(length, middle - other_half, 0),
                                      gp_Pnt(length, middle + other_half, 0)));
  outline.Add(high);
  outline.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, middle - half, 0), gp_Pnt(0, middle + half, 0)));
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, height)).Shape();
}

// A bar whose sides are splines.
TopoDS_Shape wing() {
  const std::vector<double> halves = {14, 11, 9, 10, 12};
  const auto side = [&](int sign) {
    TColgp_Array1OfPnt points(1, 5);
    for (int i = 0; i < 5; ++i)
      points.SetValue(i + 1, gp_Pnt(length * i / 4, middle + sign * halves[static_cast<std::size_t>(i)], 0));
    return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve()).Edge();
  };
  return between(side(-1), side(1), halves.front(), halves.back());
}

// A bar whose sides are arcs.
TopoDS_Shape lens() {
  const auto side = [&](int sign) {
    return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(gp_Pnt(0, middle + sign * 8, 0),
                                                      gp_Pnt(length / 2, middle + sign * 13, 0),
                                                      gp_Pnt(length, middle + sign * 8, 0))
                                       .Value())
        .Edge();
  };
  return between(side(-1), side(1), 8, 8);
}

// Round ends of radius 5, from y to y.
TopoDS_Shape long_hole(double from, double to) {
  TopoDS_Shape result = BRepPrimAPI_MakeBox(gp_Pnt(13, from, 7), gp_Pnt(31, to, 17)).Shape();
  for (const double x : {13.0, 31.0})
    result = BRepAlgoAPI_Fuse(result,
                              BRepPrimAPI_MakeCylinder(gp_Ax2({x, from, 12}, gp::DY()), 5, to - from).Shape())
                 .Shape();
  return result;
}

// One closed spline, like an egg, from y to y.
TopoDS_Shape egg(double from, double to) {
  constexpr int count = 8;
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points->SetValue(i + 1,
                     gp_Pnt(22 + 11 * std::cos(angle), from, 12 + (5 - std::cos(angle)) * std::sin(angle)));
  }
  GeomAPI_Interpolate interpolation(points, true, 1e-7);
  interpolation.Perform();
  const TopoDS_Wire outline = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(interpolation.Curve()).Edge());
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline, true).Face(), gp_Vec(0, to - from, 0))
      .Shape();
}

// Two flats at the upper end of a round pin with a chamfer, and a hole through them.
TopoDS_Shape flatted_pin() {
  TopoDS_Shape result =
      BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(15, 60).Shape(),
                       BRepPrimAPI_MakeCone(gp_Ax2({0, 0, 60}, gp::DZ()), 15, 14, 1).Shape())
          .Shape();
  for (const double x : {11.0, -16.0})
    result = cut(result, BRepPrimAPI_MakeBox(gp_Pnt(x, -16, 36), gp_Pnt(x + 5, 16, 62)).Shape());
  return cut(result, BRepPrimAPI_MakeCylinder(gp_Ax2({-12, 0, 48}, gp::DX()), 4, 24).Shape());
}

}  // namespace

std::map<std::string, TopoDS_Shape> slotted() {
  const TopoDS_Shape bar = BRepPrimAPI_MakeBox(gp_Pnt(0, 8, 0), gp_Pnt(length, 32, height)).Shape();
  return {
      {"flatted_pin", flatted_pin()},
      {"slotted_bar", pin_hole(cut(bar, long_hole(0, 40)))},
      {"slotted_wing", pin_hole(cut(wing(), egg(0, 40)))},
      {"pocketed_wing", pin_hole(cut(wing(), egg(0, 18)))},
      {"slotted_lens", pin_hole(cut(lens(), long_hole(0, 40)))},
      {"bored_lens",
       pin_hole(cut(lens(), BRepPrimAPI_MakeCylinder(gp_Ax2({25, 0, 12}, gp::DY()), 6, 40).Shape()))},
  };
}
