#pragma once

#include <array>

#include "geometry/base/progress.hpp"
#include "geometry/multi_patch.hpp"
#include "segmentation/parameterization/fit_options.hpp"
#include "segmentation/parameterization/hex_model.hpp"
#include "segmentation/parameterization/optimization_options.hpp"
#include "segmentation/parameterization/parameterization_report.hpp"

namespace isopatch::segmentation {

enum class ParameterizationMethod {
  shared,  ///< edges and faces fitted once, to a tolerance; shared control points
  paper,   ///< the five steps of the segmentation pipeline's paper, for comparison
};
inline constexpr std::array all_parameterization_methods = {ParameterizationMethod::shared,
                                                            ParameterizationMethod::paper};
/// "shared" or "paper".
const char* name(ParameterizationMethod method);

struct ParameterizationOptions {
  ParameterizationMethod method = ParameterizationMethod::shared;
  FitOptions fit;
  /// Patches whose smallest scaled Jacobian at Gauss points is below it are optimized. Range [0, 1).
  double wanted_quality = 0.2;
  /// Whether control points are moved at all; without, folds are only reported.
  bool optimize = true;
  OptimizationOptions optimization = {};
  /// Whether faces may meet parts of others; their patches then share no control points there.
  bool keep_t_joints = false;
  OptionNames names = {};
  bool operator==(const ParameterizationOptions&) const = default;
};
void validate(const ParameterizationOptions& options);

struct Parameterization {
  /// Patches in the order of the blocks, right-handed; outer faces as named boundaries; interfaces listed.
  geometry::PatchSet patches;
  ParameterizationReport report;
};

/// Turns topological hexahedra into spline volumes that share control points bit for bit where they meet.
///
/// Never fails for a fold or a deviation: the report says which patch or face, where and how much.
/// @throws Error unsupported       a face that meets only part of another one (a T-joint), naming both, unless
///                                 they are kept
/// @throws Error invalid_argument  as `validate(HexModel)`
Parameterization parameterize(const HexModel& model, const ParameterizationOptions& options = {},
                              const Progress& progress = {});

}  // namespace isopatch::segmentation
