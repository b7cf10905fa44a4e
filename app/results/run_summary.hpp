#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/base/warning.hpp"
#include "app/run/run_study.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

/// A support or a load, and where it acts.
struct SummarizedRegion {
  std::string name;                                 ///< as in the study, or "support 1"
  std::string kind;                                 ///< "roller", "pressure", ...
  std::vector<std::string> given = {};              ///< names of its faces, as the study gives them
  std::vector<std::string> faces = {};              ///< "3:west", in the input's naming
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< reaction of a support, total of a load, N
};

/// A parameter of a patch with a name, in the input's naming.
struct SummarizedPlace {
  std::string name = {};
  int patch = 0;
  Eigen::Vector3d parameter = Eigen::Vector3d::Zero();
};

/// How the equations were solved.
struct SummarizedSolver {
  std::string method = {};
  double tolerance = 0;
  int levels = 0;  ///< of a multigrid, 0 without
  std::vector<double> residual_history = {};
};

/// What pages, pictures and texts say of a run besides its fields. It comes from the run itself or, of stored
/// results, from their summary: nothing else reads that.
struct RunSummary {
  std::string title;
  std::string study;                       ///< path of its file
  std::optional<double> max_displacement;  ///< m
  std::optional<double> max_von_mises;     ///< Pa
  /// Whether max_von_mises was looked for on faces too, so that nothing shown is above it. Early versions
  /// looked at Gauss points alone.
  bool faces_searched = true;
  std::optional<double> internal_energy;  ///< J
  std::int64_t unknowns = 0;
  std::vector<SummarizedRegion> supports;
  std::vector<SummarizedRegion> loads;
  std::optional<SummarizedPlace> max_displacement_at;
  std::optional<SummarizedPlace> max_von_mises_at;
  std::vector<SummarizedPlace> probes;
  std::vector<Warning> warnings;
  SummarizedSolver solver;
  std::vector<RunLevel> levels = {};       ///< of a run on several, figures of the case
  std::optional<double> asked_error = {};  ///< in the energy norm, relative: the goal of [accuracy]

  /// The largest von Mises stress that anything shown may have, if it is known.
  std::optional<double> largest_von_mises() const { return faces_searched ? max_von_mises : std::nullopt; }
};

/// Of a study that was solved. `read_summary` gives that of stored results.
RunSummary summarized(const Study& study, const StudyRun& run);
/// Of one of its load cases.
RunSummary summarized(const Study& study, const StudyRun& run, const CaseView& one);

}  // namespace isopatch::app
