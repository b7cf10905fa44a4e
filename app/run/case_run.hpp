#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "iga/post/plane_section.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::app {

/// What is estimated of the error of the discretization; of elements it is in the solution's field.
struct RunError {
  double energy = 0;                                        ///< J
  double relative = 0;                                      ///< in the energy norm
  Eigen::Matrix3d stress_at_max = Eigen::Matrix3d::Zero();  ///< of the error, where the largest von Mises
                                                            ///< stress is, Pa
  int iterations = 0;
  /// Why the largest von Mises stress grows with refinement: "a re-entrant edge of 270 degrees"; or nothing.
  std::optional<std::string> singular = {};
};

/// Values on another side of an interface of materials at which a probe lies.
struct ProbeSide {
  int patch = 0;
  geometry::Parameter<3> parameter;  ///< in the input's naming
  std::string material;              ///< its name
  iga::FieldValues values;
};

/// Values at a probe.
struct ProbeValues {
  std::string name;
  int patch = 0;
  geometry::Parameter<3> parameter;  ///< in the input's naming
  iga::FieldValues values;
  std::optional<Eigen::Matrix3d> stress_error = {};  ///< estimated, Pa
  std::optional<std::string> singular = {};          ///< why the stress grows with refinement, if it does
  std::vector<ProbeSide> sides = {};                 ///< one for each other material that meets there
};

/// Forces of a cut.
struct SectionValues {
  std::string name;
  iga::CuttingPlane plane;
  iga::SectionForces forces;
};

/// A load case or a combination of a study.
struct CaseName {
  std::string name = {};                                     ///< "" in a study without cases
  std::vector<std::pair<std::string, double>> factors = {};  ///< of a combination, by case
  std::vector<std::string> loads = {};                       ///< of a case, as results call them
};

/// Its solution and what was looked up there.
struct CaseRun {
  CaseName name;
  iga::ElasticitySolution solution;
  std::vector<ProbeValues> probes;
  std::vector<SectionValues> sections = {};
  std::optional<RunError> error = {};
};

}  // namespace isopatch::app
