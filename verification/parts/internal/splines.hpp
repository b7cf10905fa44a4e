#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt2d.hxx>
#include <vector>

namespace isopatch::parts {

/// A curve of degree 3 by its four control points, at a height z.
TopoDS_Edge cubic(const std::vector<gp_Pnt2d>& points, double z);
/// A curve of degree 3 through points.
TopoDS_Edge spline_through(const std::vector<gp_Pnt2d>& points, double z);
/// A closed uniform cubic spline by its control points, moved to the left by `offset`, at a height z; cut
/// into edges at the knots nearest to the given places.
TopoDS_Wire closed_spline(const std::vector<gp_Pnt2d>& points, double offset, double z,
                          const std::vector<gp_Pnt2d>& cuts);
TopoDS_Wire wire(const std::vector<TopoDS_Edge>& edges);
/// The solid between two outlines of as many edges, whose sides are ruled.
TopoDS_Shape ruled(const TopoDS_Wire& from, const TopoDS_Wire& to);

}  // namespace isopatch::parts
