#pragma once

#include <optional>

#include "segmentation/decomposition/cutting/arc_on_surface.hpp"
#include "segmentation/decomposition/cutting/cell_shapes.hpp"

namespace isopatch::segmentation {

/// The curve on a surface that is straight in its domain, over [0, 1]: exact where it is straight in space or
/// a conic, as circles around an axis are.
/// @param tolerance  m, of the curve in space where it is neither
geometry::CellCurve curve_in_domain(const CellShapes& shapes, geometry::SurfaceId surface,
                                    const CurveEnd& from, const CurveEnd& to, double tolerance);

/// A curve across a face.
struct AuxiliaryCurve {
  geometry::CellCurve curve;
  /// Smallest angle that it makes with the outline at its ends, in the domain: in (0, 180) degrees.
  Angle smallest_angle;
};

/// The curve between two vertices of a face's outline that is straight in the domain; so it is straight on
/// planes, a ruling or a circle on cylinders and cones where the ends allow it.
/// @return  nothing where it would leave the face or touch its outline
/// @param tolerance  m, of the curve in space from the one in the domain where neither is straight
std::optional<AuxiliaryCurve> auxiliary_curve(const CellShapes& shapes, FaceId face, VertexId from,
                                              VertexId to, double tolerance);

/// The conic between two vertices of a face's outline in which a plane through them cuts the face.
/// @return  nothing where it would leave the face, or the face has no conic there (`arc_on_surface`)
std::optional<AuxiliaryCurve> section_curve(const CellShapes& shapes, FaceId face, VertexId from, VertexId to,
                                            const geometry::PlaneSurface& plane, double tolerance);

/// A bent curve between two vertices of a face's outline, for where the straight one leaves the face or comes
/// too close to its outline: the cubic of one bend in the domain that keeps away from the outline best.
/// @return  nothing where each that was tried leaves the face or touches its outline
/// @cost  some twenty to fifty cubics, each against all of the outline
std::optional<AuxiliaryCurve> bent_curve(const CellShapes& shapes, FaceId face, VertexId from, VertexId to,
                                         double tolerance);

}  // namespace isopatch::segmentation
