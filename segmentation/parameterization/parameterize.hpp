#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/base/progress.hpp"
#include "geometry/jacobian_certificate.hpp"
#include "geometry/measures.hpp"
#include "geometry/multi_patch.hpp"
#include "segmentation/parameterization/complex_fit.hpp"
#include "segmentation/parameterization/hex_complex.hpp"
#include "segmentation/parameterization/improve_blocks.hpp"
#include "segmentation/parameterization/shape_optimization.hpp"

namespace isopatch::segmentation {

enum class ParameterizationMethod {
  shared,  ///< edges and faces fitted once, to a tolerance; shared control points
  paper,   ///< the five steps of the segmentation pipeline's paper, for comparison
};

/// What the user calls the options that messages advise to change.
struct OptionNames {
  std::string max_spans = "max_spans";
  std::string tolerance = "tolerance";
};

struct ParameterizationOptions {
  ParameterizationMethod method = ParameterizationMethod::shared;
  FitOptions fit;
  /// Patches whose smallest scaled Jacobian at Gauss points is below it are optimized. Range [0, 1).
  double wanted_quality = 0.2;
  /// Whether control points are moved at all; without, folds are only reported.
  bool optimize = true;
  OptimizationOptions optimization = {};
  OptionNames names = {};
};
void validate(const ParameterizationOptions& options);

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
  std::vector<FaceUse> uses = {};  ///< sides of patches that it is
  DeviationGrid deviations = {};   ///< all over it
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

struct Parameterization {
  /// Patches in the order of the blocks, right-handed; outer faces as named boundaries; interfaces listed.
  geometry::PatchSet patches;
  ParameterizationReport report;
};

/// Turns topological hexahedra into spline volumes that share control points bit for bit where they meet.
///
/// Never fails for a fold or a deviation: the report says which patch or face, where and how much.
/// @throws Error unsupported  a face that meets only part of another one (a T-joint), naming both
Parameterization parameterize(const HexComplex& complex, const ParameterizationOptions& options = {},
                              const Progress& progress = {});

}  // namespace isopatch::segmentation
