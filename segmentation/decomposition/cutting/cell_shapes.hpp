#pragma once

#include <Eigen/Core>

#include "geometry/base/angle.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// The shapes of a complex: its source and the complex, which must outlive it. Lengths are metres, t runs
/// over [0, 1] from an edge's start to its end.
class CellShapes {
 public:
  CellShapes(const geometry::Brep& source, const geometry::CellComplex& complex)
      : source_(source), complex_(complex) {}

  const geometry::Brep& source() const { return source_; }
  const geometry::CellComplex& complex() const { return complex_; }

  Eigen::Vector3d point(EdgeId edge, double t) const;
  /// d point / d t.
  Eigen::Vector3d tangent(EdgeId edge, double t) const;
  Eigen::Vector3d point(geometry::SurfaceId surface, const Eigen::Vector2d& uv) const;
  /// Unit normal of a face to its front.
  Eigen::Vector3d normal(FaceId face, const Eigen::Vector2d& uv) const;
  /// An edge in the domain of a face whose outline it belongs to, or on which it was made.
  /// @throws Error internal  it has no curve there
  Eigen::Vector2d domain_point(FaceId face, EdgeId edge, double t) const;
  bool is_plane(geometry::SurfaceId surface) const;
  /// Whether a loop runs clockwise around its face in the domain, which is so where the source's surface
  /// looks inwards.
  bool is_turned(FaceId face) const;
  bool is_straight(EdgeId edge) const;
  /// Whether an edge is a piece of a circle or an ellipse of the source, or a rational arc.
  bool is_arc(EdgeId edge) const;

 private:
  double curve_parameter(const geometry::CellEdge& edge, double t) const {
    return edge.low + t * (edge.high - edge.low);
  }
  /// A point of a plane of the source in its domain.
  Eigen::Vector2d plane_point(FaceId face, const Eigen::Vector3d& point) const;

  const geometry::Brep& source_;
  const geometry::CellComplex& complex_;
};

/// Outline of a face in its domain, as its loop walks it: a closed polygon of `pieces` chords an edge, or of
/// one where edges and surface are straight; (2, n).
Eigen::Matrix2Xd outline(const CellShapes& shapes, FaceId face, int pieces = 16);

/// The angle inside a cell between two of its faces along their common edge, in (0, 360) degrees.
/// @param use     of the edge, as the first face's boundary walks it with the cell inside
/// @param second  the other face
Angle inner_angle(const CellShapes& shapes, geometry::CellFaceUse first, geometry::CellFaceUse second,
                  geometry::EdgeUse use, double t);

}  // namespace isopatch::segmentation
