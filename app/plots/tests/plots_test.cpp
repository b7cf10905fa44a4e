#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <pugixml.hpp>

#include "app/plots/axis_ticks.hpp"
#include "app/plots/bar_plot.hpp"
#include "app/plots/line_plot.hpp"
#include "app/plots/residual_plot.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double of_the_picture = 0.011;  // coordinates have two decimals

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> result;
  for (const Tick& tick : ticks)
    if (!tick.text.empty()) result.push_back(tick.text);
  return result;
}

// A picture as its reader's program sees it. ISOPATCH_PICTURES names a folder that keeps it for a person.
class Picture {
 public:
  template <class Plot>
  Picture(const Plot& plot, const std::string& name) {
    const std::string svg = to_svg(plot);
    const auto parsed = document_.load_string(svg.c_str(), pugi::parse_full);
    EXPECT_TRUE(parsed) << parsed.description() << " at " << parsed.offset << " of\n" << svg;
    EXPECT_THAT(svg, testing::Not(HasSubstr("nan")));
    EXPECT_THAT(svg, testing::Not(HasSubstr("inf,")));
    if (const char* folder = std::getenv("ISOPATCH_PICTURES"))
      std::ofstream(std::string(folder) + "/" + name + ".svg") << svg;
  }

  pugi::xml_node root() const { return document_.child("svg"); }
  /// Elements of a kind whose class begins with a word.
  std::vector<pugi::xml_node> elements(const std::string& kind, const std::string& css_class) const {
    std::vector<pugi::xml_node> result;
    for (const auto& node : root().children(kind.c_str()))
      if (std::string(node.attribute("class").value()).starts_with(css_class)) result.push_back(node);
    return result;
  }
  /// The element of a text.
  pugi::xml_node text(const std::string& text) const {
    for (const auto& node : root().children("text"))
      if (node.text().get() == text) return node;
    ADD_FAILURE() << "the picture has no text '" << text << "'";
    return {};
  }
  double x_of(const std::string& label) const { return text(label).attribute("x").as_double(); }
  /// Tick labels of the vertical axis stand four below their tick.
  double y_of(const std::string& label) const { return text(label).attribute("y").as_double() - 4; }

 private:
  pugi::xml_document document_;
};

LinePlot convergence() {
  return {
      .title = "Error over the element size",
      .description = "Relative error in energy",
      .x = {.label = "element size", .unit = "mm", .scale = Scale::logarithmic},
      .y = {.label = "relative error", .unit = "", .scale = Scale::logarithmic},
      .series = {
          {.name = "degree 2", .x = {8, 4, 2, 1}, .y = {1e-2, 2.4e-3, 6.2e-4, 1.5e-4}, .expected_slope = 2},
          {.name = "degree 3", .x = {8, 4, 2, 1}, .y = {3e-3, 2e-4, 1.2e-5, 7.6e-7}, .expected_slope = 4}}};
}

LinePlot residuals(int count) {
  LinePlot plot{.title = "Residual of each iteration",
                .description = "",
                .x = {.label = "iteration", .unit = "", .whole_numbers = true},
                .y = {.label = "relative residual", .unit = "", .scale = Scale::logarithmic},
                .series = {{.name = "elimination: cg", .x = {}, .y = {}},
                           {.name = "multipliers: minres", .x = {}, .y = {}, .dashed = true}},
                .levels = {{"tolerance", 1e-8}}};
  for (int i = 0; i < count; ++i) {
    plot.series[0].x.push_back(i);
    plot.series[0].y.push_back(std::pow(10., -20. * i / count) * (1 + 0.5 * std::sin(i)));
    plot.series[1].x.push_back(i);
    plot.series[1].y.push_back(std::pow(10., -11. * i / count));
  }
  return plot;
}

TEST(AxisTicks, AreOneTwoFiveTimesPowersOfTen) {
  EXPECT_THAT(labels(linear_ticks(0, 10)), ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_THAT(labels(linear_ticks(0, 3)), ElementsAre("0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0"));
  EXPECT_THAT(labels(linear_ticks(-0.02, 0.021)),
              ElementsAre("\u22120.02", "\u22120.01", "0.00", "0.01", "0.02"));
  EXPECT_THAT(labels(linear_ticks(1.2e5, 3.1e5)), ElementsAre("150,000", "200,000", "250,000", "300,000"));
  EXPECT_THAT(labels(linear_ticks(0, 1, 7, true)), ElementsAre("0", "1"));
  EXPECT_THAT(labels(linear_ticks(0, 4e-7)),
              ElementsAre("0", "1\u00d710\u207b\u2077", "2\u00d710\u207b\u2077", "3\u00d710\u207b\u2077",
                          "4\u00d710\u207b\u2077"));
}

TEST(AxisTicks, KeepEnoughDigitsToTellNeighboursApart) {
  EXPECT_THAT(labels(linear_ticks(68.60011, 68.60013)),
              ElementsAre("68.600110", "68.600115", "68.600120", "68.600125", "68.600130"));
  EXPECT_THAT(labels(linear_ticks(1e9, 1.003e9)),
              ElementsAre("1.0000\u00d710\u2079", "1.0005\u00d710\u2079", "1.0010\u00d710\u2079",
                          "1.0015\u00d710\u2079", "1.0020\u00d710\u2079", "1.0025\u00d710\u2079",
                          "1.0030\u00d710\u2079"));
}

TEST(AxisTicks, OfLogarithmicAxesAreDecades) {
  EXPECT_THAT(labels(logarithmic_ticks(0.5, 2e6)),
              ElementsAre("1", "10", "100", "1,000", "10,000", "100,000", "10\u2076"));
  EXPECT_THAT(labels(logarithmic_ticks(1e-12, 1)),
              ElementsAre("10\u207b\u00b9\u00b2", "10\u207b\u00b9\u2070", "10\u207b\u2078", "10\u207b\u2076",
                          "10\u207b\u2074", "0.01", "1"));
  const std::vector<Tick> ticks = logarithmic_ticks(1, 100);
  EXPECT_EQ(labels(ticks).size(), 3);
  EXPECT_EQ(ticks.size(), 19);  // 1 .. 9, 10 .. 90, 100
}

TEST(AxisTicks, OfShortLogarithmicAxesStandBetweenTheDecades) {
  EXPECT_THAT(labels(logarithmic_ticks(15, 90)), ElementsAre("20", "50"));
  EXPECT_THAT(labels(logarithmic_ticks(3100, 4300)),
              ElementsAre("3,200", "3,400", "3,600", "3,800", "4,000", "4,200"));
}

TEST(NumberText, HasThreeDigits) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(1234.5), "1,234");
  EXPECT_EQ(number_text(73746), "73,746");
  EXPECT_EQ(number_text(0.04571), "0.0457");
  EXPECT_EQ(number_text(2.0004), "2");
  EXPECT_EQ(number_text(-2.979), "\u22122.98");
  EXPECT_EQ(number_text(3.2e-7), "3.2\u00d710\u207b\u2077");
  EXPECT_EQ(number_text(9.9999e6), "1\u00d710\u2077");
  EXPECT_EQ(number_text(nan), "-");
}

TEST(LinePlot, PutsPointsWhereTheirTicksAre) {
  const Picture picture(LinePlot{.title = "",
                                 .description = "",
                                 .x = {.label = "x", .unit = "", .scale = Scale::logarithmic},
                                 .y = {.label = "y", .unit = "", .scale = Scale::linear},
                                 .series = {{.name = "", .x = {1, 100, 10000}, .y = {0, 20, 80}}}},
                        "places");
  const auto points = picture.elements("circle", "f1");
  ASSERT_EQ(points.size(), 3);
  EXPECT_NEAR(points[1].attribute("cx").as_double(), picture.x_of("100"), of_the_picture);
  EXPECT_NEAR(points[2].attribute("cx").as_double(), picture.x_of("10,000"), of_the_picture);
  EXPECT_NEAR(points[1].attribute("cy").as_double(), picture.y_of("20"), of_the_picture);
  EXPECT_NEAR(points[2].attribute("cy").as_double(), picture.y_of("80"), of_the_picture);
  EXPECT_LT(points[2].attribute("cy").as_double(), points[1].attribute("cy").as_double());
  EXPECT_NEAR(picture.x_of("100") - picture.x_of("10"), picture.x_of("10") - picture.x_of("1"),
              2 * of_the_picture);
  EXPECT_NEAR(picture.x_of("100") - picture.x_of("10"), picture.x_of("1,000") - picture.x_of("100"),
              2 * of_the_picture);
}

TEST(LinePlot, LeavesOutWhatHasNoPlaceAndBreaksTheLine) {
  LinePlot plot = convergence();
  plot.series = {{.name = "a", .x = {1, 2, 3, 4, 5, 6, 7}, .y = {1, 2, 0, 4, 5, nan, -1}},
                 {.name = "b", .x = {1, infinity, 0}, .y = {infinity, 1, 1}}};
  const Picture picture(plot, "broken");
  EXPECT_EQ(picture.elements("circle", "f1").size(), 4 + 1);      // and one in the legend
  EXPECT_EQ(picture.elements("polyline", "curve s1").size(), 2);  // 1, 2 and 4, 5
  EXPECT_EQ(picture.elements("polyline", "curve s2").size(), 0);
}

TEST(LinePlot, DrawsAnythingThatItIsGiven) {
  for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
    for (const std::vector<double>& values : {std::vector<double>{},
                                              {7},
                                              {0},
                                              {3, 3},
                                              {-2, -2},
                                              {1, 1 + 1e-15},
                                              {nan, infinity},
                                              {1e308, -1e308},
                                              {5e-324, 1e-308},
                                              {1e-200, 1e200},
                                              {-1, 1}}) {
      LinePlot plot = convergence();
      plot.x.scale = plot.y.scale = scale;
      plot.series = {{.name = "values", .x = values, .y = values, .expected_slope = 1}};
      const Picture picture(plot, "anything");
      EXPECT_GE(picture.elements("text", "text").size(), 4);  // labels and two ticks at least
    }
  }
  const Picture nothing(LinePlot{}, "nothing");
}

TEST(LinePlot, SaysTheMeasuredSlopeBesideTheExpectedOne) {
  const LinePlot plot = convergence();
  EXPECT_NEAR(measured_slope(plot.series[0]).value(), std::log2(6.2 / 1.5), 1e-12);
  EXPECT_EQ(measured_slope({.name = "", .x = {1, 2}, .y = {0, 1}}), std::nullopt);
  EXPECT_EQ(measured_slope({.name = "", .x = {1, 1}, .y = {2, 1}}), std::nullopt);
  const Picture picture(plot, "convergence");
  EXPECT_TRUE(picture.text("degree 2: slope 2.05, expected 2"));
  EXPECT_EQ(picture.elements("polygon", "slope").size(), 2);
}

TEST(LinePlot, DrawsTheTriangleWithTheExpectedSlope) {
  LinePlot plot = convergence();
  plot.series = {{.name = "exact", .x = {1, 10, 100}, .y = {1e-3, 1e-5, 1e-7}, .expected_slope = -2}};
  const Picture picture(plot, "slope");
  std::vector<double> numbers;
  std::string points = picture.elements("polygon", "slope").at(0).attribute("points").value();
  std::replace(points.begin(), points.end(), ',', ' ');
  std::istringstream stream(points);
  for (double number = 0; stream >> number;) numbers.push_back(number);
  ASSERT_EQ(numbers.size(), 6);
  const double decade_x = picture.x_of("100") - picture.x_of("10");
  const double decade_y = (picture.y_of("10\u207b\u2077") - picture.y_of("0.001")) / 4;
  EXPECT_NEAR((numbers[3] - numbers[1]) / decade_y / ((numbers[2] - numbers[0]) / decade_x), 2, 1e-3);
}

TEST(LinePlot, MarksSomePointsOfLongSeries) {
  const Picture picture(residuals(1000), "residuals");
  EXPECT_LE(picture.elements("circle", "f1").size(), 14);
  EXPECT_GE(picture.elements("circle", "f1").size(), 12);
  EXPECT_NEAR(picture.elements("line", "level").at(0).attribute("y1").as_double(),
              picture.y_of("10\u207b\u2078"), of_the_picture);
  const Picture few(residuals(18), "residuals_few");
  EXPECT_EQ(few.elements("circle", "f1").size(), 18 + 1);
}

TEST(LinePlot, IsReadableByProgramsOfTheBlind) {
  const Picture picture(convergence(), "accessible");
  EXPECT_STREQ(picture.root().attribute("role").value(), "img");
  EXPECT_STREQ(picture.root().child("title").text().get(), "Error over the element size");
  EXPECT_STREQ(picture.root().child("desc").text().get(), "Relative error in energy");
}

TEST(LinePlot, StaysXmlWithAnyText) {
  LinePlot plot = convergence();
  plot.title = "<b> & \"quotes\" \x01\x1f";
  plot.x.label = "]]> </svg>";
  plot.series[0].name = std::string(300, '&') + "\u00fc";
  const Picture picture(plot, "escaped");
  EXPECT_STREQ(picture.root().child("title").text().get(), "<b> & \"quotes\"   ");
}

TEST(LinePlot, RefusesSeriesWithoutPairs) {
  LinePlot plot = convergence();
  plot.series[1].y.pop_back();
  try {
    to_svg(plot);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("'degree 3'"));
  }
}

TEST(ResidualPlot, IsOfIterationsAndNotOfADirectMethodsRefinement) {
  EXPECT_FALSE(residual_plot({}, 1e-10));
  EXPECT_FALSE(residual_plot({{"elimination: cholmod", {1, 1e-16}}, {"multipliers: mumps", {}}}, 1e-10));
  const auto plot = residual_plot(
      {{"elimination: cholmod", {1, 1e-14}}, {"multipliers: minres", {1, 0.1, 1e-5, 1e-11}, true}}, 1e-10);
  ASSERT_TRUE(plot);
  ASSERT_EQ(plot->series.size(), 2);
  EXPECT_THAT(plot->series[1].x, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(plot->y.label, "relative residual");  // one of them is
  EXPECT_EQ(plot->levels[0].value, 1e-10);
  EXPECT_EQ(residual_plot({{"cg", {1, 1, 1, 1}, true}}, 1e-10)->y.label, "relative error, about in energy");
  const Picture picture(*plot, "residual_plot");
}

BarPlot phases() {
  return {.title = "Time per phase",
          .description = "Seconds",
          .label = "time",
          .unit = "s",
          .parts = {"model", "coupling and loads", "assembly", "solve", "results"},
          .bars = {{"elimination", {0.02, 0.1, 0.42, 3.5, 0.3}},
                   {"Lagrange multipliers", {0.02, 0.1, nan, 8, 0}}}};
}

TEST(BarPlot, DrawsLengthsInProportion) {
  const Picture picture(phases(), "phases");
  const auto solve = picture.elements("rect", "f4");
  ASSERT_EQ(solve.size(), 3);  // two bars and the legend
  const double unit = (picture.x_of("8") - picture.x_of("0")) / 8;
  EXPECT_NEAR(solve[0].attribute("width").as_double(), 3.5 * unit, of_the_picture);
  EXPECT_NEAR(solve[0].attribute("x").as_double(), picture.x_of("0") + 0.54 * unit, of_the_picture);
  EXPECT_EQ(picture.elements("rect", "f3").size(), 2);
  EXPECT_TRUE(picture.text("4.34 s"));
  EXPECT_STREQ(solve[1].child("title").text().get(), "Lagrange multipliers, solve: 8 s");
}

TEST(BarPlot, DrawsAnythingThatItIsGiven) {
  const Picture nothing(BarPlot{}, "no_bars");
  BarPlot plot = phases();
  plot.bars[0].values = {nan, infinity, -1, 0, 0};
  plot.bars[1].values = {0, 0, 0, 0, 0};
  const Picture zeros(plot, "zeros");
  EXPECT_TRUE(zeros.text("0 s"));
}

TEST(BarPlot, RefusesBarsWithMissingParts) {
  BarPlot plot = phases();
  plot.bars[1].values.pop_back();
  EXPECT_ERROR(to_svg(plot), ErrorCode::invalid_argument, "values for");
}

}  // namespace
}  // namespace isopatch::app
