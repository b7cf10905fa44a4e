#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/study/face_selection.hpp"

namespace isopatch::app {

/// Force per area of faces, Pa.
struct Traction {
  FaceSelection selection = {};
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  bool operator==(const Traction&) const = default;
};

/// Pushes against faces where positive, Pa.
struct Pressure {
  FaceSelection selection = {};
  double value = 0;
  bool operator==(const Pressure&) const = default;
};

/// A total force, spread evenly over the area of all its faces, N.
struct Force {
  FaceSelection selection = {};
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  bool operator==(const Force&) const = default;
};

/// Force per volume of patches, N/m^3.
struct BodyForce {
  PatchSelection patches = {};
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  bool operator==(const BodyForce&) const = default;
};

/// Acceleration of gravity in patches, whose materials need a density, m/s^2.
struct Gravity {
  PatchSelection patches = {};
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  bool operator==(const Gravity&) const = default;
};

/// What acts on some faces or in some patches: [[load]].
struct AppliedLoad {
  std::string name = {};  ///< for messages: "load 1 (wind)"
  std::string key = {};   ///< what results call it: its name, or "load 1"
  std::variant<Traction, Pressure, Force, BodyForce, Gravity> load = {};
  Place place = {};
  std::vector<std::string> cases = {};  ///< the load cases that it acts in; none in a study without
  bool operator==(const AppliedLoad&) const = default;
};

/// "traction", "pressure", "force", "body_force" or "gravity", as its key in the study.
std::string_view kind_name(const AppliedLoad& load);

/// The faces on which it acts; nullptr for one that acts in patches.
const FaceSelection* faces_of(const AppliedLoad& load);
FaceSelection* faces_of(AppliedLoad& load);

/// The patches in which it acts; nullptr for one that acts on faces.
const PatchSelection* patches_of(const AppliedLoad& load);
PatchSelection* patches_of(AppliedLoad& load);

}  // namespace isopatch::app
