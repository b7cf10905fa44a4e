#pragma once

#include <Eigen/Core>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

namespace isopatch::geometry {

/// A curve of a face's contour in its domain, walked from first to last, which may be the smaller one.
struct ContourCurve {
  Handle(Geom2d_Curve) curve;
  double first = 0, last = 0;
  /// The edge in space where the file has it, by the same parameter: what the curve in the domain follows
  /// only approximately on curved surfaces.
  Handle(Geom_Curve) edge = {};
};

/// The closed contour of a face in its domain, the face to the left of it if it lies along its surface.
struct FaceContour {
  std::vector<ContourCurve> curves;  ///< in no order; seams and edges without length are among them
  /// Of the straight lines among them that close gaps between ends that do not meet: the longest on the
  /// surface, in units of the shape. Nothing to speak of where the surface degenerates (a pole), the
  /// circumference where a contour closes around a periodic surface only.
  double longest_bridge = 0;
};

/// @param face  oriented along its surface. One without wires has the bounds of its surface as contour.
FaceContour face_contour(const TopoDS_Face& face, const GeomAdaptor_Surface& surface);

}  // namespace isopatch::geometry
