#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run/run_study.hpp"
#include "app/study/parse_study.hpp"
#include "verification/claims/expect.hpp"

namespace isopatch::verification {

/// A study as a user runs it, solved.
struct SolvedStudy {
  ClaimStudy named;
  app::StudyRun run;

  const app::ProbeValues& probe(const std::string& name) const {
    for (const app::ProbeValues& probe : run.probes)
      if (probe.name == name) return probe;
    throw std::out_of_range("no probe " + name);
  }
};

/// @param file  from the root of the tree
inline SolvedStudy solved(const std::string& file, const std::vector<std::string>& overrides = {}) {
  const std::filesystem::path path = std::filesystem::path(ISOPATCH_SOURCE_DIR) / file;
  return {{file, overrides}, app::run_study(app::read_study(path, overrides))};
}

}  // namespace isopatch::verification
