// The same figures whatever the number of processes and threads.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/suites/linear_field.hpp"
#include "verification/suites/several_processes.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

// Sums of other parts in another order differ by round-off, which the condition of the systems magnifies;
// direct methods refine it away, and iterations stop far below.
const Tolerance of_direct_solves = round_off(3e3, "sums in another order and a factorization");
const Tolerance of_iterations = {
    1e-10, "iterations to 1e-12, minimal residuals to 3e-11, which end at other steps: 8e-12 has been seen"};

const std::vector<Launch> launches = {{1, 2}, {2, 1}, {4, 1}, {2, 2}};

class Parallel : public SeveralProcesses {};
class FullParallel : public SeveralProcesses {};

void expect_same(const std::string& of, const ClaimStudy& study, const Tolerance& same) {
  const ProgramRun alone = run_program(study, {1, 1});
  for (const Launch& launch : launches) {
    const ProgramRun several = run_program(study, launch);
    const auto claim = [&](const std::string& what, const char* unit, double reference, double value) {
      expect(Claim{fmt::format("{}, {}, {}", what, of, words(launch)), unit, ReferenceKind::other_method,
                   "1 process of 1 thread", reference, value, same, study});
    };
    ASSERT_EQ(several.processes, launch.processes) << "the launcher did not start them as one run";
    ASSERT_EQ(several.threads, launch.threads);
    claim("energy", "J", alone.energy, several.energy);
    claim("largest displacement", "m", alone.max_displacement, several.max_displacement);
    claim("estimated energy of the error", "J", alone.error_energy, several.error_energy);
    claim("difference of the displacement anywhere", "", 0,
          coefficient_difference(alone.field, several.field));
  }
}

const std::string link = "examples/link/study.toml";

TEST_F(Parallel, Elimination) {
  expect_same("link", {link, {"discretization.refine=0"}}, of_direct_solves);
}

TEST_F(Parallel, Multipliers) {
  expect_same("link", {link, {"discretization.refine=0", "coupling.method='lagrange'"}}, of_direct_solves);
}

TEST_F(Parallel, ConjugateGradients) {
  expect_same("link", {link, {"solver.method='cg'", "solver.tolerance=1e-12"}}, of_iterations);
}

// As far as round-off lets minimal residuals go.
TEST_F(Parallel, MinimalResiduals) {
  expect_same("link",
              {link,
               {"discretization.refine=0", "coupling.method='lagrange'", "solver.method='minres'",
                "solver.tolerance=3e-11"}},
              of_iterations);
}

// Rational, and cut into layers of elements where there are more processes than patches.
TEST_F(Parallel, ThickCylinder) {
  expect_same("thick cylinder",
              {"examples/thick_cylinder/study.toml", {"discretization.degree=3", "discretization.refine=1"}},
              of_direct_solves);
}

TEST_F(FullParallel, Terrific) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  for (const std::string coupling : {"elimination", "lagrange"})
    expect_same("TERRIFIC by " + coupling,
                {"examples/terrific/study.toml",
                 {"discretization.degree=2", fmt::format("coupling.method='{}'", coupling)}},
                of_direct_solves);
}

}  // namespace
}  // namespace isopatch::verification
