// Runs that refine where their error comes from, against the same study refined everywhere.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "app/run/run_accuracy.hpp"
#include "app/run/run_levels.hpp"
#include "verification/suites/solved_study.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

app::Study study_of(const ClaimStudy& named) {
  return app::read_study(std::filesystem::path(ISOPATCH_SOURCE_DIR) / named.file, named.overrides);
}

ClaimStudy with(ClaimStudy named, const std::string& more) {
  named.overrides.push_back(more);
  return named;
}

const auto keep_nothing = [](app::StudyRun&) {};

// The error of an energy that is too small, in the energy norm.
double error_of(double energy, double exact) {
  return std::sqrt((exact - energy) / exact);
}

// How many unknowns even refinement takes to an error, at least: between two levels as a power of it, and
// those of the finest where that is not as accurate.
double unknowns_for(double error, double exact, const std::vector<app::RunLevel>& levels) {
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const double before = error_of(levels[i - 1].internal_energy, exact);
    const double after = error_of(levels[i].internal_energy, exact);
    if (error < after) continue;
    const double part = std::log(before / error) / std::log(before / after);
    return static_cast<double>(levels[i - 1].unknowns) *
           std::pow(static_cast<double>(levels[i].unknowns) / static_cast<double>(levels[i - 1].unknowns),
                    part);
  }
  return static_cast<double>(levels.back().unknowns);
}

struct Compared {
  std::string of;
  ClaimStudy study;
  int levels = 2;         // of even refinement, finer than the adaptive run
  std::string accuracy;   // of the adaptive run
  std::string reference;  // of a run whose energy stands for the exact one
};

void expect_half_of_the_unknowns(const Compared& c) {
  const app::StudyRun even = app::run_levels(study_of(c.study), c.levels, keep_nothing);
  const ClaimStudy adaptive = with(c.study, "accuracy.energy='" + c.accuracy + "'");
  const app::StudyRun found = app::run_accuracy(study_of(adaptive), keep_nothing);
  const app::StudyRun finest = app::run_accuracy(
      study_of(with(with(c.study, "accuracy.energy='" + c.reference + "'"), "accuracy.refinements=30")),
      keep_nothing);
  ASSERT_TRUE(found.accuracy->missing.empty()) << found.accuracy->missing;
  ASSERT_TRUE(finest.accuracy->missing.empty()) << finest.accuracy->missing;
  const double exact =
      finest.solution.results.internal_energy * (1 + finest.error->relative * finest.error->relative);
  const double error = error_of(found.solution.results.internal_energy, exact);
  expect(
      Claim{.what = fmt::format(
                "unknowns of the adaptive run for those of even refinement with the same error, {}", c.of),
            .kind = ReferenceKind::other_method,
            .source = "half of them",
            .reference = 0.5,
            .value = static_cast<double>(found.solution.size.dofs) / unknowns_for(error, exact, even.levels),
            .study = adaptive,
            .comparison = Comparison::at_most,
            .least = 0.001});
  expect(Claim{.what = fmt::format("error in the energy norm for the one that was asked for, {}", c.of),
               .kind = ReferenceKind::other_method,
               .source = c.reference + " estimated",
               .reference = 2,
               .value = error / *found.accuracy->asked.energy,
               .study = adaptive,
               .comparison = Comparison::at_most,
               .least = 0.2});
}

TEST(Adaptivity, LBracket) {
  expect_half_of_the_unknowns(
      {.of = "L-bracket",
       .study = {"verification/studies/bracket.toml", {"discretization={ degree = 2, refine = 1 }"}},
       .levels = 4,
       .accuracy = "6 %",
       .reference = "2 %"});
}

TEST(Adaptivity, PlateWithHole) {
  expect_half_of_the_unknowns(
      {.of = "plate with a hole",
       .study = {"examples/plate_with_hole/study.toml",
                 {"discretization={ degree = [2, 2, 1], elements_per_direction = [4, 2, 1] }"}},
       .levels = 4,
       .accuracy = "1 %",
       .reference = "0.1 %"});
}

// Its patches meet in circles around the bores, so that sheets run far.
TEST(FullAdaptivity, Terrific) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  expect_half_of_the_unknowns({.of = "TERRIFIC",
                               .study = {"examples/terrific/study.toml", {}},
                               .levels = 2,
                               .accuracy = "2.1 %",
                               .reference = "0.9 %"});
}

}  // namespace
}  // namespace isopatch::verification
