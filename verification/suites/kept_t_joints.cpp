// Complexes with T-joints, solved as they are, against the same solids cut until all sides meet as a whole.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/base/tests/data_file.hpp"
#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

/// Of whole models, without T-joints.
const std::vector<std::string> without_t_joints = {"segmentation.t_joints='remove'",
                                                   "coupling.non_matching='refuse'"};

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// @param elements  per direction of the conforming model's patches
void expect_as_without(const std::string& name, const std::string& study,
                       const std::vector<std::string>& overrides, int elements) {
  const SolvedStudy kept = solved(study, overrides);
  const SolvedStudy whole =
      solved(study, joined(joined(overrides, without_t_joints),
                           {fmt::format("discretization.elements_per_direction={}", elements)}));
  const auto unknowns = [](const SolvedStudy& solved) {
    return static_cast<double>(solved.run.built.problem.discretization.node_count());
  };
  expect(Claim{name + ", T-joints kept: energy",
               "J",
               ReferenceKind::other_method,
               fmt::format("the model that meets side to side, {} control points", unknowns(whole)),
               whole.run.solution.results.internal_energy,
               kept.run.solution.results.internal_energy,
               {5e-3, "errors of both discretizations at clamped and concave edges"},
               kept.named});
  expect(Claim{.what = name + ", T-joints kept: control points",
               .kind = ReferenceKind::other_method,
               .source = "those of the model that meets side to side",
               .reference = unknowns(whole),
               .value = unknowns(kept),
               .study = kept.named,
               .comparison = Comparison::at_most,
               .least = 1});
}

TEST(FullSegmentation, KeptTJointsOfTheSciencePark) {
  ISOPATCH_NEEDS_DATA("solids/ffoSciencePark2.xml");
  expect_as_without("Science Park", "examples/t_joints/study.toml",
                    {"model.file=" + test::data_file("solids/ffoSciencePark2.xml").string()}, 2);
}

// Curved faces that overlap in part, neither within the other.
TEST(FullSegmentation, KeptTJointsOfTheDemonstrator) {
  expect_as_without("demonstrator", "examples/t_joints/demonstrator.toml",
                    {"model.file=" + std::string(ISOPATCH_PARTS) + "/demonstrator.step"}, 1);
}

}  // namespace
}  // namespace isopatch::verification
