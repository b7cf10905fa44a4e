#pragma once

#include <string>

namespace isopatch::segmentation {

/// How a solid was taken apart.
struct DecompositionReport {
  /// What it was seen as, whose hexahedra are then known: "swept along z: ...", "turned about z: ..."; "" if
  /// it was cut.
  std::string seen_as;
  int cuts = 0;                ///< that the search made
  int cells = 0;               ///< base solids that it ended with
  int t_joints = 0;            ///< sides then that met others in parts
  bool t_joints_kept = false;  ///< not removed
  int further_cuts = 0;        ///< that made them meet side to side
  bool by_tetrahedra = false;  ///< instead of further cuts: all cells divided around a point inside
  int hexahedra = 0;           ///< in the end
  int evaluations = 0;         ///< cuts tried while searching
  double seconds = 0;
};

}  // namespace isopatch::segmentation
