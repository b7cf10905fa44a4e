#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/problem/applied_region.hpp"
#include "app/problem/mass_properties.hpp"
#include "app/problem/model_report.hpp"
#include "app/problem/stage_folder.hpp"
#include "app/study/study.hpp"
#include "iga/post/plane_section.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::app {

/// A probe, found in the model.
struct LocatedProbe {
  std::string name;
  int patch = 0;
  geometry::Parameter<3> parameter;  ///< as isopatch numbers it
};

/// A cut, found in the model.
struct LocatedSection {
  std::string name;
  iga::CuttingPlane plane;
  std::vector<iga::SectionPoint> points;
};

/// A study made ready to be solved.
struct BuiltProblem {
  iga::ElasticityProblem problem;
  ModelReport report;
  std::vector<AppliedRegion> supports;  ///< in the study's order
  std::vector<AppliedRegion> loads;
  std::vector<LocatedProbe> probes;
  std::vector<Warning> warnings;
  std::optional<segmentation::ParameterizationReport> parameterization = {};  ///< of a model made of solids
  std::vector<LocatedSection> sections = {};
  std::optional<MassProperties> mass = {};  ///< nothing where a material has no density
  std::vector<StageReport> stages = {};     ///< of a model made of solids
};

}  // namespace isopatch::app
