#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/hex/hex_topology.hpp"
#include "geometry/jacobian_certificate.hpp"
#include "geometry/measures.hpp"
#include "segmentation/parameterization/deviation_grid.hpp"
#include "segmentation/parameterization/face_map_kind.hpp"

namespace isopatch::segmentation {

/// What the user calls the options that messages advise to change.
struct OptionNames {
  std::string max_spans = "max_spans";
  std::string tolerance = "tolerance";
  bool operator==(const OptionNames&) const = default;
};

/// Where the edges and faces of a block leave no regular map: a dihedral angle of 180 degrees or more, or of
/// 0.
struct FoldedEdge {
  geometry::Parameter<3> parameter;  ///< on an edge of the cube
  Eigen::Vector3d place;
  double scaled_jacobian =
      0;  ///< there; on edges it depends on edges and faces alone, and its sign on their angle
};

/// One patch.
struct PatchReport {
  std::string name;
  geometry::JacobianCertificate certificate;
  geometry::Quality quality;
  std::optional<FoldedEdge> folded_edge;  ///< why no map can be certified, where that is known
  std::array<int, 10>
      histogram{};    ///< of the scaled Jacobian at Gauss points, tenths of [0, 1]; below 0 in the first
  double volume = 0;  ///< model units^3
  int control_points = 0;
  bool certified_before = false;  ///< without optimization
  bool moved = false;             ///< whether optimization changed it
};

/// One face of the complex.
struct FaceReport {
  std::string name;  ///< "block:face", of both blocks
  FaceMapKind kind = FaceMapKind::coons;
  double deviation = 0;  ///< largest distance of the patch from the surface at equal parameters, or from the
                         ///< edges, model units
  double gap = 0;        ///< between the two blocks' surfaces, as given
  std::vector<geometry::HexFaceUse> uses = {};  ///< sides of patches that it is
  DeviationGrid deviations = {};                ///< all over it
  double off_edges = 0;  ///< of where surfaces meet from the solid's edges in space: a fault of the solid
};

struct ParameterizationReport {
  double size = 0;       ///< of the model
  double tolerance = 0;  ///< allowed deviation, model units
  int max_spans = 0;     ///< most that any direction was allowed; 0 where the method inserts no knots
  OptionNames names = {};
  std::vector<PatchReport> patches;
  std::vector<FaceReport> faces;
  std::vector<std::string> warnings;  ///< that reading the blocks gave cause to
  double largest_gap = 0;             ///< between outlines of faces along an edge, as given, model units
  std::string gap_at;                 ///< the edge's block and vertices' places
  int rounds = 0;                     ///< of knot insertion
  int evaluations = 0;                ///< of the shape energy
  double seconds = 0;

  bool certified() const;
  const FaceReport& worst_face() const;
  /// Certified, and all deviations within the tolerance.
  bool usable() const;
  /// What is not as it should be, a line each: which patch or face, where, by how much and what to try.
  std::vector<std::string> complaints() const;
};

}  // namespace isopatch::segmentation
