#include "verification/parts/internal/shapes.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace isopatch::parts {
namespace {

/// Where x goes right and z up; y goes away from who looks.
gp_Ax3 front_view(double y) {
  return {gp_Pnt(0, y, 0), gp::DY().Reversed(), gp::DX()};
}

TopoDS_Shape only_solid(const TopoDS_Shape& shape) {
  TopExp_Explorer solids(shape, TopAbs_SOLID);
  if (!solids.More()) throw std::runtime_error("nothing is left of a solid");
  const TopoDS_Shape solid = solids.Current();
  solids.Next();
  if (solids.More()) throw std::runtime_error("a solid falls into pieces");
  return solid;
}

TopTools_ListOfShape list_of(const std::vector<TopoDS_Shape>& shapes, std::size_t from = 0) {
  TopTools_ListOfShape list;
  for (std::size_t i = from; i < shapes.size(); ++i) list.Append(shapes[i]);
  return list;
}

TopoDS_Shape combined(BRepAlgoAPI_BooleanOperation&& operation, const TopTools_ListOfShape& shapes,
                      const TopTools_ListOfShape& tools) {
  operation.SetArguments(shapes);
  operation.SetTools(tools);
  operation.Build();
  if (operation.HasErrors()) throw std::runtime_error("two solids cannot be combined");
  ShapeUpgrade_UnifySameDomain unify(operation.Shape());
  unify.Build();
  return only_solid(unify.Shape());
}

std::vector<TopoDS_Edge> chosen_edges(const TopoDS_Shape& shape, const IsChosen& is_chosen) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  std::vector<TopoDS_Edge> result;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges(i)));
    if (is_chosen(curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2)))
      result.push_back(TopoDS::Edge(edges(i)));
  }
  if (result.empty()) throw std::runtime_error("no edge is where one is to be rounded");
  return result;
}

}  // namespace

TopoDS_Shape box(gp_Pnt from, gp_Pnt to) {
  return BRepPrimAPI_MakeBox(from, to).Shape();
}

TopoDS_Shape cylinder(gp_Pnt from, gp_Dir direction, double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(from, direction), radius, length).Shape();
}

TopoDS_Shape upright_cylinder(double x, double y, double radius, double from, double to) {
  return cylinder({x, y, from}, gp::DZ(), radius, to - from);
}

TopoDS_Shape cone(gp_Pnt from, gp_Dir direction, double radius, double other_radius, double length) {
  return BRepPrimAPI_MakeCone(gp_Ax2(from, direction), radius, other_radius, length).Shape();
}

TopoDS_Shape drilled(gp_Pnt from, gp_Dir direction, double radius, double depth) {
  return joined({cylinder(from, direction, radius, depth),
                 cone(from.Translated(gp_Vec(direction) * depth), direction, radius, 0,
                      radius / std::tan(59 * std::numbers::pi / 180))});
}

TopoDS_Shape prism(const Outline& outline, double from, double to) {
  return BRepPrimAPI_MakePrism(outline.face(gp_Ax3(gp_Pnt(0, 0, from), gp::DZ(), gp::DX())),
                               gp_Vec(0, 0, to - from))
      .Shape();
}

TopoDS_Shape prism_along_y(const Outline& outline, double from, double to) {
  return BRepPrimAPI_MakePrism(outline.face(front_view(to)), gp_Vec(0, from - to, 0)).Shape();
}

TopoDS_Shape prism_along_x(const Outline& outline, double from, double to) {
  return BRepPrimAPI_MakePrism(outline.face(gp_Ax3(gp_Pnt(from, 0, 0), gp::DX(), gp::DY())),
                               gp_Vec(to - from, 0, 0))
      .Shape();
}

TopoDS_Shape turned(const Outline& outline) {
  return BRepPrimAPI_MakeRevol(outline.face(front_view(0)), gp::OZ()).Shape();
}

TopoDS_Shape joined(const std::vector<TopoDS_Shape>& parts) {
  return combined(BRepAlgoAPI_Fuse(), list_of({parts.front()}), list_of(parts, 1));
}

TopoDS_Shape without(const TopoDS_Shape& shape, const std::vector<TopoDS_Shape>& tools) {
  return combined(BRepAlgoAPI_Cut(), list_of({shape}), list_of(tools));
}

TopoDS_Shape common(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return combined(BRepAlgoAPI_Common(), list_of({a}), list_of({b}));
}

TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius, const IsChosen& is_chosen) {
  BRepFilletAPI_MakeFillet fillet(shape);
  for (const TopoDS_Edge& edge : chosen_edges(shape, is_chosen)) fillet.Add(radius, edge);
  return only_solid(fillet.Shape());
}

TopoDS_Shape chamfered(const TopoDS_Shape& shape, double distance, const IsChosen& is_chosen) {
  BRepFilletAPI_MakeChamfer chamfer(shape);
  for (const TopoDS_Edge& edge : chosen_edges(shape, is_chosen)) chamfer.Add(distance, edge);
  return only_solid(chamfer.Shape());
}

TopoDS_Shape rounded_at(const TopoDS_Shape& shape, double rounding, const std::vector<gp_Pnt2d>& circles) {
  return rounded(shape, rounding, [&](const gp_Pnt& p) {
    const gp_Pnt2d here(std::hypot(p.X(), p.Y()), p.Z());
    return std::any_of(circles.begin(), circles.end(),
                       [&](const gp_Pnt2d& circle) { return here.Distance(circle) < 1e-6; });
  });
}

std::vector<gp_Pnt> on_circle(int count, double radius, double z, double first) {
  std::vector<gp_Pnt> places;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (first + double(i) / count);
    places.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return places;
}

}  // namespace isopatch::parts
