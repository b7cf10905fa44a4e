#include "app/results/run_summary.hpp"

#include "app/results/read_summary.hpp"
#include "app/results/summary.hpp"
#include "app/study/parse_study.hpp"
#include "app/tests/program_fixture.hpp"
#include "app/verify/verified_claim.hpp"
#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::app {
namespace {

void expect_same(const std::vector<SummarizedRegion>& a, const std::vector<SummarizedRegion>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].kind, b[i].kind);
    EXPECT_EQ(a[i].given, b[i].given);
    EXPECT_EQ(a[i].faces, b[i].faces);
    EXPECT_EQ(a[i].force, b[i].force);
  }
}

void expect_same(const std::optional<SummarizedPlace>& a, const std::optional<SummarizedPlace>& b) {
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->name, b->name);
  EXPECT_EQ(a->patch, b->patch);
  EXPECT_EQ(a->parameter, b->parameter);
}

TEST(RunSummary, OfARunAndOfItsStoredTextAreTheSame) {
  // A load that moves nothing gives a warning; the iterative method a history.
  const std::string text = bar + "[[load]]\nname = \"idle\"\nfaces = [\"x_min\"]\ntraction = [1, 0, 0]\n";
  const Study study =
      parse_study(text, "study.toml",
                  {"model.orientation_seed=3", "solver.method=cg", "solver.preconditioner=block_jacobi"});
  const StudyRun run = run_study(study);
  const RunSummary direct = summarized(study, run);
  const auto stored = read_summary(summary_json(study, run));
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->title, "bar");
  EXPECT_EQ(stored->study, direct.study);
  EXPECT_EQ(stored->max_displacement, direct.max_displacement);
  EXPECT_EQ(stored->largest_von_mises(), direct.largest_von_mises());
  EXPECT_EQ(stored->internal_energy, direct.internal_energy);
  EXPECT_EQ(stored->unknowns, direct.unknowns);
  expect_same(stored->supports, direct.supports);
  EXPECT_THAT(direct.supports[0].given, testing::ElementsAre("x_min", "y_min", "z_min"));
  expect_same(stored->loads, direct.loads);
  expect_same(stored->max_displacement_at, direct.max_displacement_at);
  expect_same(stored->max_von_mises_at, direct.max_von_mises_at);
  ASSERT_EQ(stored->probes.size(), 1u);
  expect_same(stored->probes[0], direct.probes[0]);
  ASSERT_EQ(stored->warnings.size(), direct.warnings.size());
  EXPECT_GE(direct.warnings.size(), 1u);
  for (std::size_t i = 0; i < direct.warnings.size(); ++i) {
    EXPECT_EQ(stored->warnings[i].text, direct.warnings[i].text);
    EXPECT_EQ(stored->warnings[i].patch, direct.warnings[i].patch);
    EXPECT_EQ(stored->warnings[i].place, direct.warnings[i].place);
  }
  EXPECT_EQ(stored->solver.method, "cg");
  EXPECT_EQ(stored->solver.tolerance, direct.solver.tolerance);
  EXPECT_EQ(stored->solver.levels, direct.solver.levels);
  EXPECT_EQ(stored->solver.residual_history, direct.solver.residual_history);
  EXPECT_GE(direct.solver.residual_history.size(), 2u);
}

TEST(RunSummary, LeavesOutWhatAnotherTextLacks) {
  EXPECT_FALSE(read_summary("no JSON"));
  EXPECT_FALSE(read_summary("[1, 2]"));
  const auto summary = read_summary(R"({"title": 3, "results": {"max_von_mises": 7, "max_displacement": null},
    "supports": {"name": "x"}, "loads": [{"name": "pull", "faces": ["0:west", 3], "total": [1, null, 2]}],
    "probes": [{"name": "end"}], "warnings": ["look", 4], "warning_places": [null]})");
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->title, "");
  EXPECT_EQ(summary->max_von_mises, 7);
  EXPECT_FALSE(summary->largest_von_mises()) << "of Gauss points alone, as early versions wrote it";
  EXPECT_FALSE(summary->max_displacement);
  EXPECT_TRUE(summary->supports.empty());
  ASSERT_EQ(summary->loads.size(), 1u);
  EXPECT_THAT(summary->loads[0].faces, testing::ElementsAre("0:west"));
  EXPECT_EQ(summary->loads[0].force, Eigen::Vector3d(1, 0, 2));
  EXPECT_TRUE(summary->probes.empty());
  ASSERT_EQ(summary->warnings.size(), 2u);
  EXPECT_FALSE(summary->warnings[0].place);
}

TEST(RunSummary, TheSameRunGivesTheSameText) {
  const Study study = parse_study(bar, "study.toml");
  const StudyRun run = run_study(study);
  EXPECT_EQ(summary_json(study, run), summary_json(study, run));
  EXPECT_GT(json::parse(summary_json(study, run))["memory"]["peak_bytes"].get<double>(), 1e6);
}

TEST(VerifiedClaim, KeepsWhatTheRecordSays) {
  const auto claims = read_claims(R"([
    {"suite": "S", "test": "T", "what": "u", "unit": "m", "kind": "exact", "source": "", "reference": null,
     "value": 2.5, "difference": null, "comparison": "relative", "least": null, "allowed": null, "why": "", "study": null,
     "verdict": "reported"},
    {"suite": "S", "test": "T", "what": "order of u", "unit": "", "kind": "", "source": "", "reference": 3,
     "value": 3.1, "difference": 0.1, "comparison": "absolute", "least": null, "allowed": 0.3, "reason": "coarse levels", "study": {"file": "a", "set": ["b=1"]},
     "convergence": {"sizes": [1, 0.5], "errors": [1e-2, null], "orders": [null]}, "verdict": "holds"},
    {"suite": "S", "test": "T", "what": "broke", "verdict": "nonsense"}])");
  ASSERT_EQ(claims.size(), 3u);
  ASSERT_TRUE(claims[0].figures);
  EXPECT_FALSE(claims[0].figures->reference);
  EXPECT_EQ(claims[0].figures->value, 2.5);
  EXPECT_EQ(claims[0].figures->comparison, "relative");
  EXPECT_EQ(claims[1].figures->reason, "coarse levels");
  EXPECT_EQ(claims[0].why, "");
  EXPECT_FALSE(claims[0].study);
  EXPECT_EQ(claims[0].verdict, Verdict::reported);
  EXPECT_EQ(claims[1].study->overrides, std::vector<std::string>{"b=1"});
  EXPECT_TRUE(std::isnan(claims[1].convergence->errors[1]));
  EXPECT_EQ(claims[1].verdict, Verdict::holds);
  EXPECT_FALSE(claims[2].figures);
  EXPECT_EQ(claims[2].verdict, Verdict::fails) << "a verdict that is none";
  EXPECT_ERROR(read_claims("{}"), ErrorCode::bad_format, "no array of claims");
}

}  // namespace
}  // namespace isopatch::app
