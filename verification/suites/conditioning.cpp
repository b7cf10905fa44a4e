// Condition numbers of the two systems: isopatch's estimate from its own products and solutions, against all
// eigenvalues of the dense matrix.

#include "iga/solution/condition.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/claims/expect.hpp"
#include "verification/suites/dense_systems.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/solved_study.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

// A study's problem, with the study's name.
struct NamedProblem {
  ClaimStudy named;
  iga::ElasticityProblem problem;
};

NamedProblem built(const std::string& file, std::vector<std::string> overrides, iga::Coupling coupling) {
  overrides.push_back(fmt::format("coupling.method={}", iga::name(coupling)));
  const std::filesystem::path path = std::filesystem::path(ISOPATCH_SOURCE_DIR) / file;
  return {{file, overrides}, app::build_problem(app::read_study(path, overrides)).problem};
}

// The smallest eigenvalue of the largest system, 1e-5 of the largest, is found to 6e-10; of small ones to
// round-off.
const Tolerance of_extreme_eigenvalues = {
    6e-9, "where the iteration for extreme eigenvalues stops, 6e-10 on the link"};

TEST(Coupling, ConditionOfBothSystems) {
  for (const ModelCase& model : model_cases())
    for (const iga::Coupling coupling : iga::all_couplings) {
      std::vector<std::string> overrides = pulled_overrides(model);
      overrides.insert(overrides.end(), {"discretization.degree=1", "discretization.refine=0"});
      const NamedProblem p = built("verification/studies/pulled.toml", overrides, coupling);
      const Eigen::VectorXd eigenvalues =
          sorted_eigenvalues(dense(system_of(p.problem, coupling))).cwiseAbs();
      expect(Claim{fmt::format("{} as it is, {}: condition number", model.name, iga::name(coupling)), "",
                   ReferenceKind::other_method, "all eigenvalues of the dense matrix",
                   eigenvalues.tail<1>()[0] / eigenvalues[0],
                   iga::estimate_condition(p.problem, coupling).number(), of_extreme_eigenvalues, p.named});
    }
}

TEST(FullCoupling, ConditionOfLargerSystems) {
  const auto show = [](const std::string& what, const std::string& file,
                       const std::vector<std::string>& more) {
    for (const iga::Coupling coupling : iga::all_couplings) {
      const NamedProblem p = built(file, more, coupling);
      report(Figure{.what = fmt::format("{}, {}: condition number", what, iga::name(coupling)),
                    .unit = "",
                    .kind = ReferenceKind::other_method,
                    .source = "isopatch compare --condition",
                    .value = iga::estimate_condition(p.problem, coupling).number(),
                    .why = "too large for all eigenvalues",
                    .study = p.named});
    }
  };
  for (const ModelCase& model : model_cases())
    show(model.name + ", p = 2, refined once", "verification/studies/pulled.toml", pulled_overrides(model));
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  show("TERRIFIC, p = 2", "examples/terrific/study.toml", {"discretization.degree=2"});
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  show("chair stand", "examples/chair_stand/study.toml", {});
}

}  // namespace
}  // namespace isopatch::verification
