#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/run/compare_couplings.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

/// Which refinements of a study are compared.
struct LevelOptions {
  int count = 1;                  ///< the study's discretization.refine, one more, ...; 1 .. 11
  std::vector<int> degrees = {};  ///< all levels with each of these, 1 .. 10; empty: with the study's
  bool condition = false;         ///< estimate the condition of systems that are factorized
};

/// The discretizations of all levels, degree by degree, the coarsest of each first.
/// @throws Error invalid_argument naming field, value and range
std::vector<iga::DiscretizationOptions> level_discretizations(const Study& study,
                                                              const LevelOptions& options);

/// What has been compared.
struct LevelReport {
  std::vector<CouplingComparison> levels;
  std::string stopped;  ///< why levels are missing, or nothing
};

/// Compares the couplings level by level. A level for which memory does not suffice ends the work, and what
/// is finished stays; on several processes, and on the first level, it is an error.
/// @param finished  called after each level with it and all levels so far
/// @throws Error as compare_couplings
LevelReport compare_levels(const Study& study, const LevelOptions& options,
                           const std::function<void(const ComparedStudy& level,
                                                    const std::vector<CouplingComparison>& all)>& finished,
                           const Progress& progress = {});

}  // namespace isopatch::app
