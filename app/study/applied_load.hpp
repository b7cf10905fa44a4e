#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/study/face_selection.hpp"
#include "iga/problem/hydrostatic_load.hpp"
#include "iga/problem/remote_load.hpp"
#include "iga/problem/rotation_load.hpp"
#include "iga/problem/thermal_load.hpp"

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

/// A total force, N, spread evenly over the area of all its faces, over points, or along lines.
struct Force {
  FaceSelection selection = {};
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> points = {};  ///< instead of faces, m
  std::vector<Eigen::Vector3d> line = {};    ///< instead of faces: straight from each to the next, m
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

/// A total force that a pin or a shaft presses on faces with, N.
struct Bearing {
  FaceSelection selection = {};
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  bool operator==(const Bearing&) const = default;
};

/// A force and a moment at a point, carried to faces that may deform.
struct Remote {
  FaceSelection selection = {};
  iga::RemoteForce value = {};
  bool operator==(const Remote&) const = default;
};

/// The pressure of a liquid on faces.
struct Hydrostatic {
  FaceSelection selection = {};
  iga::Liquid value = {};
  bool operator==(const Hydrostatic&) const = default;
};

/// Acceleration of the part itself, as seen from patches, whose materials need a density, m/s^2.
struct Acceleration {
  PatchSelection patches = {};
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  bool operator==(const Acceleration&) const = default;
};

/// Rotation of patches, whose materials need a density.
struct Rotating {
  PatchSelection patches = {};
  iga::Rotation value = {};
  bool operator==(const Rotating&) const = default;
};

/// A change of temperature of patches, whose materials need an expansion.
struct Temperature {
  PatchSelection patches = {};
  iga::TemperatureChange value = {};
  bool operator==(const Temperature&) const = default;
};

/// What acts on some faces or in some patches: [[load]].
struct AppliedLoad {
  std::string name = {};  ///< for messages: "load 1 (wind)"
  std::string key = {};   ///< what results call it: its name, or "load 1"
  std::variant<Traction, Pressure, Force, Bearing, Remote, Hydrostatic, BodyForce, Gravity, Acceleration,
               Rotating, Temperature>
      load = {};
  Place place = {};
  std::vector<std::string> cases = {};  ///< the load cases that it acts in; none in a study without
  bool operator==(const AppliedLoad&) const = default;
};

/// "traction", "pressure", "force", ..., as its key in the study.
std::string_view kind_name(const AppliedLoad& load);

/// The faces on which it acts; nullptr for one that acts in patches.
const FaceSelection* faces_of(const AppliedLoad& load);
FaceSelection* faces_of(AppliedLoad& load);

/// The patches in which it acts; nullptr for one that acts on faces.
const PatchSelection* patches_of(const AppliedLoad& load);
PatchSelection* patches_of(AppliedLoad& load);

}  // namespace isopatch::app
