#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/study/face_selection.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::app {

/// Components of the displacement that are given, and a gradient.
struct HeldDisplacement {
  iga::PrescribedDisplacement displacement;
  std::optional<FaceConditions> edges = {};  ///< holds edges of the faces selected and not the faces
  std::vector<Eigen::Vector3d> points = {};  ///< holds these places and no faces, m
  std::vector<Eigen::Vector3d> line = {};    ///< holds straight lines from each to the next, m
  bool operator==(const HeldDisplacement&) const = default;
};

/// No displacement along the normal of a plane face.
struct Symmetry {
  bool operator==(const Symmetry&) const = default;
};

/// A displacement along the normal of a plane face, m, outwards.
struct Roller {
  double normal_displacement = 0;
  bool operator==(const Roller&) const = default;
};

/// Faces about an axis, held where true.
struct Cylindrical {
  bool radial = true;
  bool tangential = false;
  bool axial = false;
  std::optional<Eigen::Vector3d> point = {};  ///< on the axis, m; none: the axis of the faces
  std::optional<Eigen::Vector3d> axis = {};
  bool operator==(const Cylindrical&) const = default;
};

/// Springs under faces: per area, N/m^3, and of all together, N/m.
struct Elastic {
  double normal = 0;
  double tangential = 0;
  double total_normal = 0;
  double total_tangential = 0;
  bool operator==(const Elastic&) const = default;
};

/// Six conditions, or as many as other supports leave, that no balanced load feels.
struct FreeBody {
  bool operator==(const FreeBody&) const = default;
};

/// What holds some faces: [[support]].
struct SupportInput {
  std::string name = {};  ///< for messages: "support 1 (wall)"
  std::string key = {};   ///< what results call it: its name, or "support 1"
  FaceSelection selection = {};
  std::variant<HeldDisplacement, Symmetry, Roller, Cylindrical, Elastic, FreeBody> condition = {};
  /// Load cases in which it moves its faces by what it prescribes, while it holds them at 0 in others; none:
  /// in all.
  std::vector<std::string> cases = {};
  bool operator==(const SupportInput&) const = default;
};

/// "displacement", "symmetry", "roller", ..., as its key in the study.
std::string_view kind_name(const SupportInput& support);

}  // namespace isopatch::app
