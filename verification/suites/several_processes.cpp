#include "verification/suites/several_processes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isopatch::verification {

void expect_same_energy(const std::string& file, const std::vector<std::string>& overrides,
                        const Tolerance& allowed) {
  expect_same_energy_of(file, {}, overrides, allowed);
}

void expect_same_energy_of(const std::string& file, const std::vector<std::string>& of_both,
                           std::vector<std::string> overrides, const Tolerance& allowed) {
  const std::string path = "verification/studies/" + file + ".toml";
  overrides.insert(overrides.begin(), of_both.begin(), of_both.end());
  const ProgramRun alone = run_program({path, of_both}, {1, 1});
  const ProgramRun several = run_program({path, overrides}, {2, 1});
  expect(Claim{fmt::format("energy of {} by {} as 2 processes", file, fmt::join(overrides, ", ")),
               "J",
               ReferenceKind::other_method,
               "one process, factorized",
               alone.energy,
               several.energy,
               allowed,
               {path, overrides}});
}

}  // namespace isopatch::verification
