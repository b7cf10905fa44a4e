#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "app/study/face_selection.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::app {

/// Components of the displacement that are given, and a gradient.
struct HeldDisplacement {
  iga::PrescribedDisplacement displacement;
  std::optional<FaceConditions> edges = {};  ///< holds edges of the faces selected and not the faces
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

/// What holds some faces: [[support]].
struct SupportInput {
  std::string name = {};  ///< for messages: "support 1 (wall)"
  std::string key = {};   ///< what results call it: its name, or "support 1"
  FaceSelection selection = {};
  std::variant<HeldDisplacement, Symmetry, Roller> condition = {};
  /// Load cases in which it moves its faces by what it prescribes, while it holds them at 0 in others; none:
  /// in all.
  std::vector<std::string> cases = {};
  bool operator==(const SupportInput&) const = default;
};

/// "displacement", "symmetry" or "roller", as its key in the study.
std::string_view kind_name(const SupportInput& support);

}  // namespace isopatch::app
