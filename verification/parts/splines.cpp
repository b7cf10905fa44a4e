#include "verification/parts/internal/splines.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <algorithm>
#include <gp_Vec2d.hxx>

namespace isopatch::parts {
namespace {

gp_Pnt at_height(gp_Pnt2d p, double z) {
  return {p.X(), p.Y(), z};
}

/// Each point to the left of the way from the one before to the one behind.
std::vector<gp_Pnt2d> moved_left(const std::vector<gp_Pnt2d>& points, double offset) {
  std::vector<gp_Pnt2d> result;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const gp_Vec2d along(points[(i + n - 1) % n], points[(i + 1) % n]);
    result.push_back(points[i].Translated(gp_Vec2d(-along.Y(), along.X()).Normalized() * offset));
  }
  return result;
}

Handle(Geom_BSplineCurve) periodic(const std::vector<gp_Pnt2d>& points, double z) {
  const int n = static_cast<int>(points.size());
  TColgp_Array1OfPnt poles(1, n);
  for (int i = 0; i < n; ++i) poles(i + 1) = at_height(points[std::size_t(i)], z);
  TColStd_Array1OfReal knots(1, n + 1);
  for (int i = 0; i <= n; ++i) knots(i + 1) = i;
  TColStd_Array1OfInteger multiplicities(1, n + 1);
  multiplicities.Init(1);
  return new Geom_BSplineCurve(poles, knots, multiplicities, 3, true);
}

double nearest_knot(const Geom_BSplineCurve& curve, gp_Pnt2d place, double z) {
  double nearest = 0;
  for (int i = 1; i < curve.NbKnots(); ++i)
    if (curve.Value(curve.Knot(i)).Distance(at_height(place, z)) <
        curve.Value(nearest).Distance(at_height(place, z)))
      nearest = curve.Knot(i);
  return nearest;
}

}  // namespace

TopoDS_Edge cubic(const std::vector<gp_Pnt2d>& points, double z) {
  TColgp_Array1OfPnt poles(1, 4);
  for (int i = 0; i < 4; ++i) poles(i + 1) = at_height(points[std::size_t(i)], z);
  return BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)).Edge();
}

TopoDS_Edge spline_through(const std::vector<gp_Pnt2d>& points, double z) {
  const Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    places->SetValue(static_cast<int>(i) + 1, at_height(points[i], z));
  GeomAPI_Interpolate interpolation(places, false, 1e-7);
  interpolation.Perform();
  return BRepBuilderAPI_MakeEdge(interpolation.Curve()).Edge();
}

TopoDS_Wire closed_spline(const std::vector<gp_Pnt2d>& points, double offset, double z,
                          const std::vector<gp_Pnt2d>& cuts) {
  const Handle(Geom_BSplineCurve) unmoved = periodic(points, z);
  const Handle(Geom_BSplineCurve) curve = periodic(moved_left(points, offset), z);
  std::vector<double> at;
  for (const gp_Pnt2d& place : cuts) at.push_back(nearest_knot(*unmoved, place, z));
  std::sort(at.begin(), at.end());
  at.push_back(at.front() + static_cast<double>(points.size()));
  std::vector<TopoDS_Edge> edges;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const Handle(Geom_BSplineCurve) piece = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
    piece->Segment(at[i], at[i + 1]);
    edges.push_back(BRepBuilderAPI_MakeEdge(piece).Edge());
  }
  return wire(edges);
}

TopoDS_Wire wire(const std::vector<TopoDS_Edge>& edges) {
  BRepBuilderAPI_MakeWire result;
  for (const TopoDS_Edge& edge : edges) result.Add(edge);
  return result.Wire();
}

TopoDS_Shape ruled(const TopoDS_Wire& from, const TopoDS_Wire& to) {
  BRepOffsetAPI_ThruSections sections(true, true);
  sections.CheckCompatibility(false);
  sections.AddWire(from);
  sections.AddWire(to);
  sections.Build();
  return sections.Shape();
}

}  // namespace isopatch::parts
