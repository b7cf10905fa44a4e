#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/pages/display_unit.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/output/part_samples.hpp"

namespace isopatch::app {

/// A field on the samples of all patches.
struct SceneField {
  std::string key;    ///< "von_mises"
  std::string label;  ///< "Von Mises stress"
  DisplayUnit unit;
  std::string on = {};                  ///< "interfaces" if it is NaN elsewhere
  std::vector<Eigen::MatrixXd> values;  ///< per patch (components, samples), SI
  /// Whether its numbers are written as multiples of 1/32767 of the largest one: half as many bytes.
  bool is_short = false;
};

/// A support or a load and the faces on which it acts.
struct SceneRegion {
  std::string name;
  std::string kind;                                 ///< "roller", "pressure", ...
  std::vector<std::string> faces;                   ///< "3:west", in the input's naming
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< reaction of a support, total of a load, N
};

/// A point whose values are known exactly.
struct SceneMarker {
  std::string name;
  std::string kind;  ///< "probe", "max_displacement", "max_von_mises", "difference"
  int patch = 0;
  geometry::Parameter<3> parameter;  ///< in the input's naming
  Eigen::Vector3d place;
  Eigen::Vector3d displacement;
  double von_mises = 0;
};

struct SceneWarning {
  std::string text;
  std::optional<int> patch;
  std::optional<Eigen::Vector3d> place;
};

/// A patch's names in the input.
struct ScenePatch {
  std::string name;
  std::array<std::string, 6> faces;               ///< west, east, south, north, front, back
  std::array<std::vector<double>, 3> parameters;  ///< of the samples, in the input's naming: they
                                                  ///< decrease where a patch was reversed
};

/// What a page shows in three dimensions.
struct Scene {
  const geometry::MultiPatch* model = nullptr;  ///< how the sampled patches meet; must outlive the scene
  iga::PartSamples samples;
  iga::SamplingOptions sampling;
  std::vector<ScenePatch> patches;
  DisplayUnit length;
  std::vector<SceneField> fields;  ///< besides the displacement, which must be one of them to deform the part
  std::vector<SceneRegion> supports;
  std::vector<SceneRegion> loads;
  std::vector<SceneMarker> markers;
  std::vector<SceneWarning> warnings;
};

/// The JSON text of a scene; numbers at the samples as base64 of single precision.
/// @cost  4 bytes and a third for each number, half of that for those of short fields
std::string scene_json(const Scene& scene);

}  // namespace isopatch::app
