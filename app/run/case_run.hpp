#pragma once

#include <string>
#include <utility>
#include <vector>

#include "iga/post/plane_section.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::app {

/// Values at a probe.
struct ProbeValues {
  std::string name;
  int patch = 0;
  geometry::Parameter<3> parameter;  ///< in the input's naming
  iga::FieldValues values;
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
};

}  // namespace isopatch::app
