#pragma once

#include <Eigen/Core>
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "geometry/brep/measure.hpp"

namespace isopatch::geometry {

/// What a face contributes to the surface and to three times the volume of its solid, in units of its shape.
struct FaceMeasure {
  Measure area;
  Measure flux;  ///< of x - reference through the face, along S_u x S_v
  /// Of the flux's error, what gaps of the contour make, whatever the quadrature.
  double open_flux = 0;
};

/// How exact, and from where.
struct FaceMeasureOptions {
  Eigen::Vector3d reference;  ///< near the solid, the same for all its faces, so that little cancels
  double size = 1;            ///< of the solid
  double relative = 1e-8;     ///< error to stop at: of the area, as a share; of the flux, of area times size
};

/// The integrals of |S_u x S_v| and (S - reference).(S_u x S_v) over the trimmed domain of a face.
///
/// By Green's theorem in the domain: the integral of f is that of F dv around the contour, F being that of f
/// along u from the left end of the domain to the contour. Both are cut at the knots of curves and surface
/// and taken adaptively.
/// @param face     oriented along its surface
/// @param surface  of the face, in the model's frame
FaceMeasure measure_face(const TopoDS_Face& face, const Handle(Geom_Surface) & surface,
                         const FaceMeasureOptions& options);

}  // namespace isopatch::geometry
