#include "verification/claims/claim_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "geometry/base/atomic_file.hpp"

namespace isopatch::verification {
namespace {

using Json = nlohmann::ordered_json;

Json& all() {
  static Json claims = Json::array();
  return claims;
}

const char* name(ReferenceKind kind) {
  switch (kind) {
    case ReferenceKind::closed_form:
      return "closed form";
    case ReferenceKind::manufactured:
      return "manufactured";
    case ReferenceKind::independent_fe:
      return "independent FE";
    case ReferenceKind::published:
      return "published";
    case ReferenceKind::seed_figure:
      return "seed figure";
    case ReferenceKind::other_method:
      return "other method";
    case ReferenceKind::exact:
      return "exact";
  }
  return "";
}

const char* name(Comparison comparison) {
  switch (comparison) {
    case Comparison::relative:
      return "relative";
    case Comparison::absolute:
      return "absolute";
    case Comparison::at_most:
      return "at most";
    case Comparison::at_least:
      return "at least";
  }
  return "";
}

// Null where JSON has no number.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json numbers(const std::vector<double>& values) {
  Json result = Json::array();
  for (const double value : values) result.push_back(number(value));
  return result;
}

Json of_test(const testing::TestInfo& test) {
  return {{"suite", test.test_suite_name()}, {"test", test.name()}};
}

Json of_running_test() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  return test ? of_test(*test) : Json{{"suite", ""}, {"test", ""}};
}

Json study_json(const ClaimStudy& study) {
  return study.file.empty() ? Json() : Json{{"file", study.file}, {"set", study.overrides}};
}

class Writer : public testing::EmptyTestEventListener {
 public:
  explicit Writer(std::string path) : path_(std::move(path)) {}

 private:
  void OnTestStart(const testing::TestInfo&) override { before_ = all().size(); }
  void OnTestEnd(const testing::TestInfo& test) override {
    const testing::TestResult& result = *test.result();
    Json entry = of_test(test);
    if (result.Skipped()) {
      entry["what"] = result.total_part_count() > 0 ? result.GetTestPartResult(0).message() : "skipped";
      entry["verdict"] = "not run";
      all().push_back(entry);
    }
    bool told = false;
    for (std::size_t i = before_; i < all().size(); ++i) told = told || all()[i]["verdict"] == "FAILS";
    if (!result.Failed() || told) return;
    entry["what"] = "the test fails outside its claims";
    for (int i = 0; i < result.total_part_count(); ++i)
      if (result.GetTestPartResult(i).failed()) entry["what"] = result.GetTestPartResult(i).message();
    entry["verdict"] = "FAILS";
    all().push_back(entry);
  }
  void OnTestProgramEnd(const testing::UnitTest&) override { write_file(path_, all().dump(1) + "\n"); }

  std::string path_;
  std::size_t before_ = 0;
};

}  // namespace

void record(const Claim& claim, bool holds) {
  Json entry = of_running_test();
  entry.update({{"what", claim.what},
                {"unit", claim.unit},
                {"kind", name(claim.kind)},
                {"source", claim.source},
                {"reference", number(claim.reference)},
                {"value", number(claim.value)},
                {"difference", number(difference(claim))},
                {"comparison", name(comparison_of(claim))},
                {"least", claim.least ? number(*claim.least) : Json()},
                {"allowed", number(claim.allowed.most)},
                {"reason", claim.allowed.reason},
                {"study", study_json(claim.study)},
                {"verdict", holds ? "holds" : "FAILS"}});
  all().push_back(entry);
}

void record(const Convergence& c, bool holds) {
  Json entry = of_running_test();
  entry.update(
      {{"what", "order of " + c.what},
       {"unit", ""},
       {"kind", name(c.kind)},
       {"source", c.source},
       {"reference", c.order},
       {"value", number(farthest_order(c))},
       {"difference", number(std::abs(farthest_order(c) - c.order))},
       {"comparison", name(Comparison::absolute)},
       {"least", Json()},
       {"allowed", c.allowed.most},
       {"reason", c.allowed.reason},
       {"study", study_json(c.study)},
       {"convergence",
        {{"sizes", numbers(c.sizes)}, {"errors", numbers(c.errors)}, {"orders", numbers(orders(c))}}},
       {"verdict", holds ? "holds" : "FAILS"}});
  all().push_back(entry);
}

void record(const Figure& figure) {
  const Claim beside{
      .what = "", .unit = "", .source = "", .reference = figure.reference, .value = figure.value};
  Json entry = of_running_test();
  entry.update({{"what", figure.what},
                {"unit", figure.unit},
                {"kind", std::isnan(figure.reference) ? "" : name(figure.kind)},
                {"source", figure.source},
                {"reference", number(figure.reference)},
                {"value", number(figure.value)},
                {"difference", number(difference(beside))},
                {"comparison", name(comparison_of(beside))},
                {"least", Json()},
                {"allowed", Json()},
                {"why", figure.why},
                {"study", study_json(figure.study)},
                {"verdict", "reported"}});
  all().push_back(entry);
}

void write_record_at_the_end() {
  if (const char* path = std::getenv("ISOPATCH_CLAIMS"))
    testing::UnitTest::GetInstance()->listeners().Append(new Writer(path));  // GoogleTest owns it
}

}  // namespace isopatch::verification
