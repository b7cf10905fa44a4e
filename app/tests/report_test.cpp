#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

json data_of(const std::string& html) {
  const std::string begin = "id=\"isopatch-data\">";
  const auto from = html.find(begin) + begin.size();
  return json::parse(html.substr(from, html.find("</script>", from) - from));
}

TEST_F(Program, WritesTheSameReportFromStoredResults) {
  ASSERT_EQ(run({"run", study()}), 0) << err_;
  const std::string written = read_file(results() / "report.html");
  const json data = data_of(written);
  EXPECT_EQ(data["kind"], "report");
  EXPECT_EQ(data["title"], "bar");
  EXPECT_EQ(data["study"], bar);
  // All but the time that writing took, which is not known before the page is written.
  json summary = json::parse(read_file(results() / "summary.json"));
  summary["timings"].erase("output");
  summary["timings"]["total"] = data["summary"]["timings"]["total"];
  EXPECT_EQ(data["summary"], summary);
  ASSERT_EQ(run({"report", (results() / "results.h5").string(), "-o", (folder_ / "again.html").string()}), 0);
  EXPECT_EQ(read_file(folder_ / "again.html"), written);
  EXPECT_EQ(out_, (folder_ / "again.html").string() + " written; open it in a browser\n");
  fs::remove(results() / "report.html");
  ASSERT_EQ(run({"report", (results() / "results.h5").string()}), 0) << err_;
  EXPECT_EQ(read_file(results() / "report.html"), written) << "beside the results by default";
}

TEST_F(Program, LeavesTheReportOutOnRequest) {
  ASSERT_EQ(run({"run", study()}), 0) << err_;
  ASSERT_EQ(run({"run", study(), "--set", "output.report=false"}), 0) << err_;
  EXPECT_FALSE(fs::exists(results() / "report.html")) << "that of the earlier run is gone too";
}

TEST_F(Program, MarksPlacesOfTheReportWithTheSummarysValues) {
  ASSERT_EQ(run({"run", study(), "--set", "model.orientation_seed=3"}), 0) << err_;
  const json data = data_of(read_file(results() / "report.html"));
  const json& summary = data["summary"];
  const json& markers = data["scene"]["markers"];
  ASSERT_EQ(markers.size(), 3u);
  const auto length = [](const json& v) {
    return std::hypot(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
  };
  EXPECT_NEAR(length(markers[0]["displacement"]), summary["results"]["max_displacement"], 1e-15);
  EXPECT_NEAR(markers[1]["von_mises"].get<double>(), summary["results"]["max_von_mises"], 1e-2);
  EXPECT_EQ(markers[2]["name"], summary["probes"][0]["name"]);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(markers[2]["displacement"][i].get<double>(), summary["probes"][0]["displacement"][i], 1e-15);
    EXPECT_NEAR(markers[2]["point"][i].get<double>(), summary["probes"][0]["point"][i], 1e-14);
  }
  // Faces are those that the study chose, whichever way the patches run.
  std::vector<std::string> held;
  for (const json& patch : data["scene"]["patches"])
    for (const json& face : patch["faces"])
      if (!face["supports"].empty()) {
        held.push_back(face["label"]);
        EXPECT_EQ(face["kind"], "boundary");
      }
  EXPECT_THAT(held, testing::UnorderedElementsAreArray(
                        summary["supports"][0]["faces"].get<std::vector<std::string>>()));
  EXPECT_NEAR(data["scene"]["loads"][0]["total"][0].get<double>(), 1e7, 1e-5);
  EXPECT_NEAR(data["scene"]["supports"][0]["reaction"][0].get<double>(), -1e7, 1e-2);
}

TEST_F(Program, SaysWhatIsWrongWithResultsForAReport) {
  EXPECT_EQ(run({"report", (folder_ / "none.h5").string()}), 3);
  EXPECT_THAT(err_, HasSubstr("none.h5"));
  EXPECT_EQ(run({"report", study()}), 2);
  EXPECT_THAT(err_, HasSubstr("study.toml"));
  ASSERT_EQ(run({"run", study()}), 0);
  EXPECT_EQ(run({"report", (results() / "results.h5").string(), "-o", "/proc/none/report.html"}), 3);
  EXPECT_THAT(err_, HasSubstr("/proc/none"));
}

}  // namespace
}  // namespace isopatch::app
