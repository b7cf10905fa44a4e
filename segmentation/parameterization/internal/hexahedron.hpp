#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/brep/read_brep.hpp"
#include "geometry/hex/cube.hpp"
#include "geometry/splines/knot_vector.hpp"
#include "segmentation/parameterization/internal/brep_splines.hpp"
#include "segmentation/parameterization/internal/domain_curve.hpp"
#include "segmentation/parameterization/internal/domain_mesh.hpp"
#include "segmentation/parameterization/internal/exact_curve.hpp"

namespace isopatch::segmentation {

using geometry::Side;

/// An edge as the solid itself has it, apart from its curves in the faces' domains.
struct SolidEdge {
  SpaceCurve curve;  ///< empty where the solid knows none
  /// Knots over [0, 1], where the curve is a polynomial spline.
  std::optional<geometry::KnotVector> knots = {};
  std::optional<ExactCurve> exact = {};  ///< where it is rational
};

/// A four-sided face in the frame (s, t) of the unit square.
struct QuadFace {
  std::string name;
  int number = 0;  ///< of the face in its solid
  /// Where t = 0 and t = 1 (over s), then where s = 0 and s = 1 (over t).
  std::array<DomainCurve, 4> sides;
  DomainSurface surface;
  std::array<SolidEdge, 4> edges = {};  ///< of the sides, in their directions
  std::optional<SplineSurfaceKnots> spline = {};
  bool is_affine = false;  ///< the surface is a plane, and its domain is mapped to it affinely
  /// Triangles of the trimmed domain, made when asked for; nothing where the CAD library gives none.
  std::function<std::optional<DomainMesh>()> mesh = {};
};

/// A topological hexahedron whose faces lie on the sides of the unit cube, right-handed.
struct Hexahedron {
  std::string name;
  std::array<Eigen::Vector3d, 8> corners;
  std::array<QuadFace, 6> faces;  ///< by side
  /// How well the edges in space are known: what was closed between faces that had no common edge, m.
  double edge_uncertainty = 0;

  const QuadFace& face(Side side) const { return faces[static_cast<std::size_t>(side)]; }
};

/// The curves and surfaces of a solid, as the parameterization works with them; m.
/// @param sides  the solid's faces by side of the cube: `cube_sides`
Hexahedron hexahedron(const geometry::BrepFile& solid, const std::array<FaceId, 6>& sides);

}  // namespace isopatch::segmentation
