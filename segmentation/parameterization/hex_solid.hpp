#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "segmentation/parameterization/cube.hpp"

namespace isopatch::segmentation {

/// A curve in the domain of a face, over [0, 1].
using DomainCurve = std::function<Eigen::Vector2d(double)>;
/// The surface above a domain; model units.
using DomainSurface = std::function<Eigen::Vector3d(const Eigen::Vector2d&)>;

/// A trimmed face of a solid: one closed loop of domain curves, curve k from corner k to corner k + 1.
struct SolidFace {
  std::string name;
  std::vector<int> corners;         ///< indices of vertices, in the loop's order, either sense
  std::vector<DomainCurve> curves;  ///< as many as corners
  DomainSurface surface;
  std::string colour = {};  ///< "#rrggbb", "" where the file has none
};

/// What the parameterization needs to know of a solid, whatever kernel holds it.
struct HexSolid {
  std::string name;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<SolidFace> faces;
};

/// A four-sided face in the frame (s, t) of the unit square.
struct QuadFace {
  std::string name;
  int number = 0;  ///< of the face in its solid
  /// Where t = 0 and t = 1 (over s), then where s = 0 and s = 1 (over t).
  std::array<DomainCurve, 4> sides;
  DomainSurface surface;
  std::string colour = {};  ///< as in SolidFace
};

/// A topological hexahedron whose faces lie on the sides of the unit cube, right-handed.
struct Hexahedron {
  std::string name;
  std::array<Eigen::Vector3d, 8> corners;
  std::array<QuadFace, 6> faces;  ///< by side

  const QuadFace& face(Side side) const { return faces[static_cast<std::size_t>(side)]; }
};

/// Finds the unit cube in a solid: its vertex 0 becomes corner 0.
///
/// @throws Error unsupported      a face that has not four corners, a solid that has not the graph of a cube
/// @throws Error not_conforming   an open shell or a non-manifold edge, naming the edge and its faces
/// @throws Error invalid_argument an edge of no length, a face whose outline crosses itself, a solid of no
/// volume All messages name solid, face and vertices.
Hexahedron hexahedron(const HexSolid& solid);

}  // namespace isopatch::segmentation
