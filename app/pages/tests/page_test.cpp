#include "app/pages/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "app/pages/internal/base64.hpp"
#include "geometry/models/box.hpp"
#include "iga/spaces/discretization.hpp"

namespace isopatch::app {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

// The inverse, as plain as can be.
std::vector<float> from_base64(const std::string& text) {
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  for (std::size_t i = 0; i + 3 < text.size(); i += 4) {
    unsigned bits = 0;
    int padding = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      padding += text[i + k] == '=' ? 1 : 0;
      bits = bits << 6 | (text[i + k] == '=' ? 0U : static_cast<unsigned>(alphabet.find(text[i + k])));
    }
    for (int k = 0; k < 3 - padding; ++k) bytes += static_cast<char>(bits >> (16 - 8 * k));
  }
  std::vector<float> numbers(bytes.size() / 4);
  std::memcpy(numbers.data(), bytes.data(), 4 * numbers.size());
  return numbers;
}

// The JSON inside the page.
json data_of(const std::string& html) {
  const std::string begin = "id=\"isopatch-data\">";
  const auto from = html.find(begin) + begin.size();
  return json::parse(html.substr(from, html.find("</script>", from) - from));
}

TEST(Base64, IsThatOfTheStandard) {
  // The bytes 00 00 80 3f, then 00 00 00 40 00 00 40 40.
  EXPECT_EQ(to_base64({1.0F}), "AACAPw==");
  EXPECT_EQ(to_base64({1.0F, 2.0F, 3.0F}), "AACAPwAAAEAAAEBA");
  EXPECT_EQ(to_base64({}), "");
  EXPECT_EQ(short_to_base64({1, -2}), "AQD+/w==");
  for (std::size_t n = 1; n < 8; ++n) {
    std::vector<float> numbers;
    for (std::size_t i = 0; i < n; ++i) numbers.push_back(0.1F * static_cast<float>(i) - 3e7F);
    EXPECT_EQ(from_base64(to_base64(numbers)), numbers);
  }
}

TEST(Page, NeedsNothingFromOutside) {
  Page page;
  page.kind = "report";
  page.program = "isopatch";
  const std::string html = to_html(page);
  for (const char* outside : {"src=", "href=\"http", "@import", "url(http"})
    EXPECT_THAT(html.substr(0, html.find("isopatch-data")), Not(HasSubstr(outside)));
  EXPECT_THAT(html, Not(HasSubstr("isopatch:scripts")));
  EXPECT_THAT(html, Not(HasSubstr("isopatch:style")));
  EXPECT_THAT(html, HasSubstr("THREE"));
}

TEST(Page, KeepsTextsThatLookLikeMarkup) {
  Page page;
  page.kind = "report";
  page.title = "<b>a & b</b>";
  page.study = "# </script><script>alert(1)</script> <!-- \xff \" \\ /*isopatch:data*/";
  page.summary_json = R"({"title": "</script>"})";
  page.plots = {{"a < b", "<svg></svg>"}};
  const std::string html = to_html(page);
  EXPECT_THAT(html, HasSubstr("<title>&lt;b>a &amp; b&lt;/b></title>"));
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  const json data = data_of(html);
  EXPECT_THAT(data["study"].get<std::string>(), HasSubstr("</script><script>alert(1)</script> <!-- "));
  EXPECT_EQ(data["summary"]["title"], "</script>");
  EXPECT_EQ(data["plots"][0]["svg"], "<svg></svg>");
  EXPECT_TRUE(data["scene"].is_null());
}

TEST(FaultScene, HasEveryPointAndMark) {
  FaultScene scene;
  scene.length = {"mm", 1e3};
  scene.faces = {{"part: face 0", "5 corners", true,
                  (Eigen::Matrix3Xd(3, 3) << 0, 1, 0, 0, 0, 2, 3, 3, 3).finished(), Eigen::Vector3i(0, 1, 2)},
                 {"part: face 1", "", false, Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0)}};
  scene.lines = {{"edge 4", true, (Eigen::Matrix3Xd(3, 2) << 0, 1, 0, 0, 0, 0).finished()}};
  scene.places = {{"vertex 7", {0, -4, 1}}};
  Page page;
  page.kind = "faults";
  page.faults = scene;
  const json data = data_of(to_html(page))["faults"];
  EXPECT_EQ(from_base64(data["faces"][0]["points"]), std::vector<float>({0, 0, 3, 1, 0, 3, 0, 2, 3}));
  EXPECT_EQ(data["faces"][0]["triangles"], json({0, 1, 2}));
  EXPECT_EQ(data["faces"][0]["remark"], "5 corners");
  EXPECT_EQ(data["faces"][1]["is_faulty"], false);
  EXPECT_EQ(data["faces"][1]["points"], "");
  EXPECT_EQ(data["lines"][0]["name"], "edge 4");
  EXPECT_EQ(data["places"][0]["point"], json({0.0, -4.0, 1.0}));
  EXPECT_EQ(data["box"]["min"], json({0.0, -4.0, 0.0}));
  EXPECT_EQ(data["box"]["max"], json({1.0, 2.0, 3.0}));
}

TEST(Scene, HasEverySampleOfEveryPatch) {
  const auto d = iga::discretize(
      geometry::connect(geometry::box_model({.patches = {2, 1, 1}, .curvature = 0.3, .seed = 4})));
  Scene scene;
  scene.model = &d.model;
  scene.samples = iga::sample_part(d.model, d.patches);
  scene.length = {"mm", 1e3};
  scene.supports = {{"left", "roller", {"0:west"}, {1, 2, 3}}};
  scene.loads = {{"right", "pressure", {"1:east", "1:north"}, {4, 5, 6}}};
  scene.warnings = {{"look", 1, Eigen::Vector3d(7, 8, 9)}, {"nowhere", {}, {}}};
  SceneField quality{"scaled_jacobian", "Scaled Jacobian", {"", 1}, "", {}};
  for (int p = 0; p < 2; ++p) {
    const auto& samples = scene.samples.patches[static_cast<std::size_t>(p)];
    quality.values.emplace_back(samples.scaled_jacobian.transpose());
    ScenePatch patch{std::to_string(p), {}, samples.parameters};
    for (const geometry::Side side : geometry::all_sides)
      patch.faces[static_cast<std::size_t>(side)] = d.model.label({PatchId(p), side});
    scene.patches.push_back(patch);
  }
  SceneField shift{"shift", "Shift", {"", 1}, "", {}, true};
  for (const ScenePatch& patch : scene.patches)
    shift.values.emplace_back(Eigen::RowVector3d(std::stod(patch.name) - 2, std::nan(""), 0.25));
  scene.fields = {quality, shift};
  const json data = json::parse(scene_json(scene));
  const std::vector<float> points = from_base64(data["points"]);
  const std::vector<float> jacobian = from_base64(data["scaled_jacobian"]);
  const auto& first = scene.samples.patches[0];
  const auto& second = scene.samples.patches[1];
  const auto count = static_cast<std::size_t>(first.points.cols());
  EXPECT_EQ(data["patches"][1]["first"], count);
  // -2, none, 0.25; -1, none, 0.25
  EXPECT_EQ(data["fields"][1]["step"], 2. / 32767);
  EXPECT_EQ(data["shift"], short_to_base64({-32767, -32768, 4096, -16384, -32768, 4096}));
  EXPECT_FALSE(data["fields"][0].contains("step"));
  ASSERT_EQ(jacobian.size(), count + static_cast<std::size_t>(second.points.cols()));
  ASSERT_EQ(points.size(), 3 * jacobian.size());
  EXPECT_EQ(points[3 * count + 4], static_cast<float>(second.points(1, 1)));
  EXPECT_EQ(jacobian[count], static_cast<float>(second.scaled_jacobian[0]));
  EXPECT_EQ(data["patches"][0]["sizes"], json(first.sizes()));
  const json& east = data["patches"][0]["faces"][1];
  EXPECT_EQ(east["kind"], "interface");
  EXPECT_EQ(data["patches"][0]["faces"][0], json({{"kind", "boundary"},
                                                  {"label", "0:west"},
                                                  {"supports", json::array({0})},
                                                  {"loads", json::array()}}));
  EXPECT_EQ(data["patches"][1]["faces"][3]["loads"], json::array({0}));
  EXPECT_EQ(data["loads"][0]["total"], json({4.0, 5.0, 6.0}));
  EXPECT_EQ(data["warnings"][0]["point"], json({7.0, 8.0, 9.0}));
  EXPECT_TRUE(data["warnings"][1]["patch"].is_null());
  EXPECT_NEAR(data["box"]["max"][0].get<double>(), 1, 1e-12);
}

}  // namespace
}  // namespace isopatch::app
