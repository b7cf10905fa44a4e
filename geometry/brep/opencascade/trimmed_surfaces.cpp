#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomConvert.hxx>
#include <ShapeAnalysis.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

// Poles of a surface stay curves of the domain here: a loop must close.
std::vector<NurbsCurve> loop_of(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  std::vector<NurbsCurve> result;
  for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next()) {
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(it.Current(), face, first, last);
    const Handle(Geom2d_TrimmedCurve) piece = new Geom2d_TrimmedCurve(curve, first, last);
    const Handle(Geom2d_BSplineCurve) spline = Geom2dConvert::CurveToBSplineCurve(piece);
    if (spline->IsPeriodic()) spline->SetNotPeriodic();
    if (it.Current().Orientation() == TopAbs_REVERSED) spline->Reverse();
    result.push_back(to_nurbs(*spline));
  }
  return result;
}

TrimmedSurface surface_of(const TopoDS_Face& face, double metres) {
  TrimmedSurface result;
  const Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(BRep_Tool::Surface(face));
  if (spline->IsUPeriodic()) spline->SetUNotPeriodic();
  if (spline->IsVPeriodic()) spline->SetVNotPeriodic();
  result.surface = to_nurbs(*spline, metres);
  const TopoDS_Wire outer = ShapeAnalysis::OuterWire(face);
  for (TopoDS_Iterator it(face); it.More(); it.Next()) {
    if (it.Value().ShapeType() != TopAbs_WIRE) continue;
    const TopoDS_Wire wire = TopoDS::Wire(it.Value());
    result.loops.insert(wire.IsSame(outer) ? result.loops.begin() : result.loops.end(), loop_of(wire, face));
  }
  return result;
}

}  // namespace

std::vector<TrimmedSurface> surfaces_of(const ShapeKernel& kernel) {
  const ShapeInput& input = kernel.input();
  BRepBuilderAPI_NurbsConvert convert(input.shape, true);
  std::vector<TrimmedSurface> result;
  for (std::size_t i = 0; i < input.faces.size(); ++i) {
    const TopoDS_Face face = TopoDS::Face(convert.ModifiedShape(input.faces[i]).Oriented(TopAbs_FORWARD));
    result.push_back(surface_of(face, input.metres));
    if (!input.names.empty()) result.back().name = input.names[i];
  }
  return result;
}

}  // namespace isopatch::geometry
