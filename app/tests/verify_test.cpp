#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

/// A stand-in for the suites: a script that lists two suites and writes the record that it is given.
class Verify : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    ::setenv("ISOPATCH_VERIFICATION", script().c_str(), 1);
    suites(
        R"([{"suite": "ClosedForms", "test": "Bar", "what": "u at the end", "unit": "m", "kind": "closed form",
      "source": "Hooke", "reference": 2.0, "value": 2.0001, "difference": 5e-5, "comparison": "relative", "least": null, "allowed": 1e-3,
      "reason": "", "study": {"file": "bar.toml", "set": ["a.b=1"]}, "verdict": "holds"}])");
  }
  void TearDown() override {
    ::unsetenv("ISOPATCH_VERIFICATION");
    Program::TearDown();
  }
  std::string script() const { return (folder_ / "it's a suite").string(); }
  fs::path output() const { return folder_ / "verified"; }
  void suites(const std::string& record, const std::string& last = "exit 1") {
    write_file(folder_ / "record", record);
    write_file(
        script(),
        "#!/bin/sh\nif [ \"$1\" = --gtest_list_tests ]; then\n"
        "  printf 'ClosedForms.\\n  Bar\\nPublished.\\n  Cook\\nFullPublished.\\n  Le10\\n'; exit 0\nfi\n"
        "echo \"$2\" > '" +
            (folder_ / "filter").string() +
            "'\n"
            "echo '[ RUN      ] ClosedForms.Bar'\n" +
            (record.empty() ? "" : "cp '" + (folder_ / "record").string() + "' \"$ISOPATCH_CLAIMS\"\n") +
            last + "\n");
    fs::permissions(script(), fs::perms::owner_all);
  }
  int verify(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"verify", "--output", output().string()});
    return run(more);
  }
};

TEST_F(Verify, PrintsAndWritesWhatHolds) {
  ASSERT_EQ(verify(), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("closed_forms\n"));
  EXPECT_THAT(out_, HasSubstr("u at the end (m)"));
  EXPECT_THAT(out_, HasSubstr("2.0001     5e-05     0.001  closed form, Hooke\n"));
  EXPECT_THAT(out_, HasSubstr("1 claims hold, 0 fail, 0 not run\n"));
  const json written = json::parse(read_file(output() / "verify.json"));
  EXPECT_EQ(written["level"], "quick");
  EXPECT_EQ(written["hold"], 1);
  EXPECT_EQ(written["claims"][0]["suite"], "closed_forms");
  EXPECT_THAT(read_file(output() / "verify.html"), HasSubstr("u at the end"));
  json claim = json::parse(read_file(folder_ / "record"))[0];
  claim["suite"] = "closed_forms";
  claim["case"] = "bar";
  EXPECT_EQ(written["claims"][0], claim) << "all that the suites record";
}

TEST_F(Verify, SaysLimitsAndReasons) {
  suites(
      R"([{"suite": "Solvers", "test": "Cg", "what": "iterations", "reference": 14, "value": 7, "difference": 0,
     "comparison": "at most", "least": 1, "allowed": 0, "verdict": "holds"},
    {"suite": "Solvers", "test": "Cg", "what": "smallest", "reference": 2, "value": 7, "difference": 0,
     "comparison": "at least", "least": null, "allowed": 0, "verdict": "holds"},
    {"suite": "Solvers", "test": "Cg", "what": "energy", "reference": 2, "value": 2, "difference": 0,
     "comparison": "relative", "least": null, "allowed": 0.001, "reason": "two programs", "verdict": "holds"}])");
  EXPECT_EQ(verify(), 0) << err_;
  EXPECT_THAT(out_, testing::ContainsRegex("iterations +14 +7 +0 +at most"));
  EXPECT_THAT(out_, testing::ContainsRegex("smallest +2 +7 +0 +at least"));
  EXPECT_THAT(out_, testing::ContainsRegex("energy +2 +2 +0 +0.001 +two programs"));
}

TEST_F(Verify, FailsAndNamesTheStudyWhereAClaimFails) {
  suites(R"([{"suite": "Published", "test": "Cook", "what": "u_y", "reference": 1, "value": 3,
    "study": {"file": "cook.toml", "set": ["discretization.degree=2", "support.0.faces=['a']"]}, "verdict": "FAILS"},
    {"suite": "Published", "test": "Le10", "what": "crashed", "verdict": "FAILS"},
    {"suite": "Published", "test": "Chair", "what": "no such file", "verdict": "not run"}])");
  EXPECT_EQ(verify(), 1);
  EXPECT_THAT(out_, HasSubstr("0 claims hold, 2 fail, 1 not run\n"));
  EXPECT_THAT(
      out_,
      HasSubstr(
          "alone: isopatch run cook.toml --set discretization.degree=2 --set \"support.0.faces=['a']\"\n"));
  EXPECT_THAT(out_, HasSubstr("alone: isopatch-verification --gtest_filter='*Le10'\n"));
  EXPECT_THAT(err_, HasSubstr("2 of the claims fail"));
  EXPECT_TRUE(fs::exists(output() / "verify.json"));
}

TEST_F(Verify, KeepsWhatWasNotRunApart) {
  suites(R"([{"suite": "Published", "test": "Chair", "what": "needs chair.xml", "verdict": "not run"},
    {"suite": "Published", "test": "Cook", "what": "u_y", "unit": "m", "reference": 7.06, "value": 6.99,
     "difference": 0.01, "allowed": null, "why": "another load", "verdict": "reported"}])");
  EXPECT_EQ(verify(), 1) << "nothing was checked";
  EXPECT_THAT(out_, HasSubstr("not run  needs chair.xml\n"));
  EXPECT_THAT(out_, HasSubstr("reported u_y (m)"));
  EXPECT_THAT(out_, HasSubstr("another load\n"));
  EXPECT_THAT(out_, HasSubstr("0 claims hold, 0 fail, 1 not run\n"));
  const json written = json::parse(read_file(output() / "verify.json"));
  EXPECT_EQ(written["not_run"], 1);
  EXPECT_EQ(written["reported"], 1);
  EXPECT_EQ(written["fail"], 0);
  EXPECT_EQ(written["suites"][0]["name"], "published");
  EXPECT_EQ(written["suites"][0]["not_run"], 1);
}

TEST_F(Verify, DrawsOrdersOfOneMeasureTogether) {
  std::string claims;
  for (int p = 1; p <= 10; ++p)
    for (const std::string& measure : {std::string("displacement"), std::string("energy")})
      claims += (claims.empty() ? "" : ",") +
                (R"({"suite": "Manufactured", "test": "Box", "what": "order of )" + measure + ", p = " +
                 std::to_string(p) + R"(, multipliers", "reference": 2.0, "value": 2, "verdict": "holds",
                 "convergence": {"sizes": [0.5, 0.25, 0.125], "errors": [4e-2, null, 1e-2]}})");
  suites("[" + claims + "]");
  ASSERT_EQ(verify(), 0) << err_;
  const std::string page = read_file(output() / "verify.html");
  const auto count = [&](const std::string& text) {
    int found = 0;
    for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("\"section\":\"manufactured\""), 4) << "eight lines a plot";
  EXPECT_THAT(page, HasSubstr("box: displacement, multipliers"));
  EXPECT_THAT(page, HasSubstr("p = 10: slope 1, expected 2"));
}

TEST_F(Verify, ChoosesSuitesByNameAndLevel) {
  ASSERT_EQ(verify(), 0);
  EXPECT_EQ(read_file(folder_ / "filter"), "--gtest_filter=ClosedForms.*:Published.*\n");
  ASSERT_EQ(verify({"published", "--level", "full"}), 0);
  EXPECT_EQ(read_file(folder_ / "filter"), "--gtest_filter=Published.*:FullPublished.*\n");
  ASSERT_EQ(run({"verify", "--list"}), 0);
  EXPECT_EQ(out_, "closed_forms\npublished\n");
  EXPECT_EQ(verify({"closed_from"}), 2);
  EXPECT_THAT(err_, HasSubstr("did you mean 'closed_forms'?"));
  EXPECT_EQ(verify({"--level", "some"}), 2);
}

TEST_F(Verify, SaysInWhichTestTheSuitesBroke) {
  suites("", "kill -SEGV $$");
  EXPECT_EQ(verify(), 3);
  EXPECT_THAT(err_, HasSubstr("signal 11 without a record, in ClosedForms.Bar"));
  EXPECT_FALSE(fs::exists(output() / "verify.json"));
}

TEST_F(Verify, IsNotContentWithNothing) {
  suites("[]", "exit 0");
  EXPECT_EQ(verify(), 1);
  EXPECT_THAT(err_, HasSubstr("no claim was checked"));
  ::setenv("ISOPATCH_VERIFICATION", "/proc/none", 1);
  EXPECT_EQ(verify(), 3);
  EXPECT_THAT(err_, HasSubstr("/proc/none"));
}

}  // namespace
}  // namespace isopatch::app
