#include "geometry/brep/tests/made_solids/closed_faces.hpp"

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <functional>
#include <gp_GTrsf.hxx>

namespace {

TopoDS_Shape stretched(const TopoDS_Shape& solid, double a, double b, double c) {
  gp_GTrsf stretch;
  stretch.SetValue(1, 1, a);
  stretch.SetValue(2, 2, b);
  stretch.SetValue(3, 3, c);
  return BRepBuilderAPI_GTransform(solid, stretch, true).Shape();
}

TopoDS_Shape ellipsoid(double a, double b, double c) {
  return stretched(BRepPrimAPI_MakeSphere(1).Shape(), a, b, c);
}

// Thick below, with a dent around its middle.
TopoDS_Shape pear() {
  TColgp_Array1OfPnt poles(1, 6);
  poles(1) = gp_Pnt(0, 0, -10);
  poles(2) = gp_Pnt(12, 0, -10);
  poles(3) = gp_Pnt(14, 0, 2);
  poles(4) = gp_Pnt(1, 0, 1);
  poles(5) = gp_Pnt(7, 0, 12);
  poles(6) = gp_Pnt(0, 0, 12);
  BRepBuilderAPI_MakeWire outline(BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)).Edge(),
                                  BRepBuilderAPI_MakeEdge(poles(6), poles(1)).Edge());
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp::OZ()).Shape();
}

// With the control points of its face moved.
TopoDS_Shape moved(const TopoDS_Shape& solid, const std::function<gp_Pnt(double, double, double)>& to) {
  TopExp_Explorer faces(solid, TopAbs_FACE);
  const auto surface =
      Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(faces.Current())));
  for (int i = 1; i <= surface->NbUPoles(); ++i)
    for (int j = 1; j <= surface->NbVPoles(); ++j) {
      const gp_Pnt p = surface->Pole(i, j);
      surface->SetPole(i, j, to(p.X(), p.Y(), p.Z()));
    }
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  builder.Add(shell, BRepBuilderAPI_MakeFace(surface, 1e-6).Face());
  shell.Closed(true);
  TopoDS_Solid result = BRepBuilderAPI_MakeSolid(shell).Solid();
  BRepLib::OrientClosedSolid(result);
  return result;
}

}  // namespace

std::map<std::string, TopoDS_Shape> closed_faces() {
  return {{"ellipsoid", ellipsoid(15, 10, 7)},
          {"pebble", stretched(pear(), 1.6, 1, 1)},
          {"creased", moved(ellipsoid(15, 10, 7),
                            [](double x, double y, double z) {
                              return gp_Pnt(x + 0.02 * z * z + 0.1 * y, y - 0.015 * x * x, z + 0.012 * x * y);
                            })},
          {"banana", moved(ellipsoid(10, 10, 40),
                           [](double x, double y, double z) { return gp_Pnt(x + 0.03 * z * z, y, z); })}};
}
