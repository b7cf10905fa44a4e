#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Pln.hxx>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

/// A circle around a tip, which begins where the cone's own parameters do: no vertex beside its seam.
gp_Circ circle_on(const TopoDS_Face& cone, const DrillTip& tip, double share, double metres) {
  const gp_Ax3 position = BRepAdaptor_Surface(cone).Cone().Position();
  const Eigen::Vector3d centre = (tip.apex + share * tip.depth * tip.axis) / metres;
  return {gp_Ax2(to_point(centre), position.Direction(), position.XDirection()), share * tip.radius / metres};
}

/// The only wire of a face in which nothing ends at the apex: circles, once each.
TopoDS_Wire circles_of(const TopoDS_Face& tip) {
  BRepBuilderAPI_MakeWire wire;
  for (TopExp_Explorer edge(tip, TopAbs_EDGE); edge.More(); edge.Next()) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(edge.Current()))) continue;
    if (BRepAdaptor_Curve(TopoDS::Edge(edge.Current())).GetType() == GeomAbs_Circle)
      wire.Add(TopoDS::Edge(edge.Current()));
  }
  return wire.Wire();
}

bool has_apex(const TopoDS_Face& face) {
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
    if (BRep_Tool::Degenerated(TopoDS::Edge(edge.Current()))) return true;
  return false;
}

}  // namespace

KernelSolid solid_with_flat_tips(const ShapeKernel& source, const std::vector<DrillTip>& tips, double share) {
  const ShapeInput& given = source.input();
  TopTools_ListOfShape solids, circles;
  solids.Append(given.shape);
  for (const DrillTip& tip : tips)
    circles.Append(BRepBuilderAPI_MakeEdge(
        circle_on(given.faces[static_cast<std::size_t>(tip.cone.value)], tip, share, given.metres)));
  BRepAlgoAPI_Splitter splitter;
  splitter.SetArguments(solids);
  splitter.SetTools(circles);
  splitter.SetRunParallel(false);
  splitter.SetNonDestructive(true);
  splitter.Build();
  if (!splitter.IsDone() || splitter.HasErrors())
    throw Error(ErrorCode::unsupported, "the CAD library cannot divide a drill's tip");
  std::vector<TopoDS_Face> faces, flats;
  std::vector<std::string> names, names_of_flats;
  std::vector<std::optional<Colour>> colours, colours_of_flats;
  for (std::size_t f = 0; f < given.faces.size(); ++f) {
    const BrepFace& known = source.tables().faces[f];
    TopTools_ListOfShape images = splitter.Modified(given.faces[f]);
    if (images.IsEmpty()) images.Append(given.faces[f]);
    const bool is_divided = images.Size() > 1;
    for (const TopoDS_Shape& image : images) {
      const TopoDS_Face face = TopoDS::Face(image);
      if (is_divided && has_apex(face)) {
        const TopoDS_Wire wire = circles_of(face);
        flats.push_back(BRepBuilderAPI_MakeFace(wire, true).Face());
        names_of_flats.push_back(known.name);
        colours_of_flats.push_back(known.colour);
        continue;
      }
      faces.push_back(face);
      names.push_back(known.name);
      colours.push_back(known.colour);
    }
  }
  faces.insert(faces.end(), flats.begin(), flats.end());
  names.insert(names.end(), names_of_flats.begin(), names_of_flats.end());
  colours.insert(colours.end(), colours_of_flats.begin(), colours_of_flats.end());
  ShapeInput input = oriented_solid(std::move(faces), given.metres);
  input.names = std::move(names);
  input.colours = std::move(colours);
  return {std::make_shared<ShapeKernel>(std::move(input)), "", 0};
}

}  // namespace isopatch::geometry
