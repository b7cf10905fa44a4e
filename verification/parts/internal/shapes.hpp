#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <gp_Ax3.hxx>
#include <vector>

#include "verification/parts/internal/outline.hpp"

namespace isopatch::parts {

/// Solids by OpenCASCADE, mm. Each throws std::runtime_error or Standard_Failure where nothing valid comes of
/// it.
TopoDS_Shape box(gp_Pnt from, gp_Pnt to);
/// From `from` along `direction`.
TopoDS_Shape cylinder(gp_Pnt from, gp_Dir direction, double radius, double length);
/// From z = from to z = to.
TopoDS_Shape upright_cylinder(double x, double y, double radius, double from, double to);
/// A countersink or the tip of a drill: from radius to other_radius.
TopoDS_Shape cone(gp_Pnt from, gp_Dir direction, double radius, double other_radius, double length);
/// A drilled hole: its tip has 118 degrees.
TopoDS_Shape drilled(gp_Pnt from, gp_Dir direction, double radius, double depth);
/// From z = from to z = to.
TopoDS_Shape prism(const Outline& outline, double from, double to);
/// Of an outline in the plane of x and z, from y = from to y = to.
TopoDS_Shape prism_along_y(const Outline& outline, double from, double to);
/// Of an outline in the plane of y and z, from x = from to x = to.
TopoDS_Shape prism_along_x(const Outline& outline, double from, double to);
/// About the z axis, of an outline of lines whose x is the radius and whose y is z. (The library leaves arcs
/// as surfaces of revolution, which no CAD program writes; rounds are to be made by `rounded_at`.)
TopoDS_Shape turned(const Outline& outline);

/// One solid; faces that continue each other are merged.
TopoDS_Shape joined(const std::vector<TopoDS_Shape>& parts);
TopoDS_Shape without(const TopoDS_Shape& shape, const std::vector<TopoDS_Shape>& tools);
TopoDS_Shape common(const TopoDS_Shape& a, const TopoDS_Shape& b);

/// Whether an edge is meant, by the point in its middle.
using IsChosen = std::function<bool(const gp_Pnt&)>;
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius, const IsChosen& is_chosen);
TopoDS_Shape chamfered(const TopoDS_Shape& shape, double distance, const IsChosen& is_chosen);

/// Rounds circles about the z axis, given by radius and z.
TopoDS_Shape rounded_at(const TopoDS_Shape& shape, double rounding, const std::vector<gp_Pnt2d>& circles);

/// The places of n holes on a circle about the z axis, the first at `first` of a turn.
std::vector<gp_Pnt> on_circle(int count, double radius, double z, double first = 0);

}  // namespace isopatch::parts
