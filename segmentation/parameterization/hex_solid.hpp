#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/splines/knot_vector.hpp"
#include "segmentation/parameterization/cube.hpp"
#include "segmentation/parameterization/domain_curve.hpp"

namespace isopatch::segmentation {

/// An edge as the solid itself has it, apart from its curves in the faces' domains.
struct SolidEdge {
  SpaceCurve curve;  ///< empty where the solid knows none
  /// Knots over [0, 1], where the curve is a polynomial spline.
  std::optional<geometry::KnotVector> knots = {};
};

/// A surface that is a polynomial spline in its domain's own parameters.
struct SplineSurfaceKnots {
  std::array<geometry::KnotVector, 2> along;  ///< by direction of the domain
};

/// A trimmed face of a solid: one closed loop of domain curves, curve k from corner k to corner k + 1.
struct SolidFace {
  std::string name;
  std::vector<int> corners;         ///< indices of vertices, in the loop's order
  std::vector<DomainCurve> curves;  ///< as many as corners
  DomainSurface surface;
  std::string colour = {};  ///< "#rrggbb", "" where the file has none
  /// As many as corners, run through as the curves are; or none.
  std::vector<SolidEdge> edges = {};
  std::optional<SplineSurfaceKnots> spline = {};
  bool is_affine = false;  ///< the surface is a plane, and its domain is mapped to it affinely
};

/// What the parameterization needs to know of a solid, whatever kernel holds it.
struct HexSolid {
  std::string name;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<SolidFace> faces;
  /// Whether every loop walks with its face to the left, seen from outside. Otherwise loops may run either
  /// way, and the sense of the solid is found from its volume.
  bool has_outward_loops = false;
  /// How well the edges in space are known: what was closed between faces that had no common edge; model
  /// units.
  double edge_uncertainty = 0;
};

/// A four-sided face in the frame (s, t) of the unit square.
struct QuadFace {
  std::string name;
  int number = 0;  ///< of the face in its solid
  /// Where t = 0 and t = 1 (over s), then where s = 0 and s = 1 (over t).
  std::array<DomainCurve, 4> sides;
  DomainSurface surface;
  std::string colour = {};                        ///< as in SolidFace
  std::array<SolidEdge, 4> edges = {};            ///< of the sides, in their directions
  std::optional<SplineSurfaceKnots> spline = {};  ///< as in SolidFace
  bool is_affine = false;                         ///< as in SolidFace
};

/// A face in a sentence: "face 3" where that is its name, otherwise "face 'lid'".
std::string face_in_words(const std::string& name);

/// A topological hexahedron whose faces lie on the sides of the unit cube, right-handed.
struct Hexahedron {
  std::string name;
  std::array<Eigen::Vector3d, 8> corners;
  std::array<QuadFace, 6> faces;  ///< by side
  double edge_uncertainty = 0;    ///< as in HexSolid

  const QuadFace& face(Side side) const { return faces[static_cast<std::size_t>(side)]; }
};

/// Finds the unit cube in a solid: its vertex 0 becomes corner 0.
///
/// Right-handed by the sense of the solid's loops where that is known; otherwise by its volume, on grids that
/// are refined until two agree.
/// @throws Error unsupported      a face that has not four corners, a solid that has not the graph of a cube
/// @throws Error not_conforming   an open shell or a non-manifold edge, naming the edge and its faces
/// @throws Error invalid_argument an edge of no length, a face whose outline crosses itself, a solid of no
/// volume. All messages name solid, face and vertices.
Hexahedron hexahedron(const HexSolid& solid);

}  // namespace isopatch::segmentation
