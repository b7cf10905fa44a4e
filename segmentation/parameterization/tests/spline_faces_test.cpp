#include <gtest/gtest.h>

#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/brep/write_brep.hpp"
#include "geometry/measures.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/transfer.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/parameterization/tests/checks.hpp"
#include "segmentation/parameterization/tests/spline_blocks.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::KnotVector;
using geometry::NurbsVolume;

/// Knots of unequal spans, the second one double if the degree allows.
KnotVector uneven(int degree, std::vector<double> inner) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0);
  if (degree > 1 && inner.size() > 1) inner.insert(inner.begin() + 1, inner[1]);
  knots.insert(knots.end(), inner.begin(), inner.end());
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1);
  return {degree, knots};
}

Eigen::Vector3d wave(const Eigen::Vector3d& p) {
  return {2 * p[0] + 0.1 * std::sin(3 * p[1]), p[1] + 0.1 * std::sin(4 * p[0]) * p[2],
          p[2] * (1 + 0.2 * std::sin(5 * p[0] + 2 * p[1]))};
}

/// The inside of a patch does not count: faces are the solid's to round-off.
void expect_exact(const Parameterization& made, double volume) {
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  EXPECT_LT(made.report.worst_face().deviation, 1e-10 * made.report.size) << made.report.worst_face().name;
  double sum = 0;
  for (const NurbsVolume& patch : made.patches.patches) sum += geometry::volume(patch);
  EXPECT_NEAR(sum, volume, 1e-9 * volume);
}

TEST(SplineFaces, AreExactOnTheirOwnKnots) {
  for (const int degree : {1, 2, 3}) {
    SCOPED_TRACE(degree);
    const NurbsVolume given =
        test::bent({uneven(degree, {0.11, 0.3, 0.34, 0.7}), uneven(2, {0.4}), uneven(1, {})}, wave);
    const Parameterization made = parameterize(hex_model({{test::solid_of(given), "block"}}));
    expect_exact(made, geometry::volume(given));
    EXPECT_EQ(made.report.rounds, 0);
  }
}

TEST(SplineFaces, OfADegreeAboveThePatchesAreFittedToTheTolerance) {
  const NurbsVolume given = test::bent({uneven(4, {0.3}), uneven(1, {}), uneven(1, {})}, wave);
  const HexModel model = hex_model({{test::solid_of(given), "block"}});
  const Parameterization cubic = parameterize(model);
  EXPECT_TRUE(cubic.report.usable());
  EXPECT_GT(cubic.report.worst_face().deviation, 1e-10 * cubic.report.size);
  ParameterizationOptions options;
  options.fit.degree = 4;
  expect_exact(parameterize(model, options), geometry::volume(given));
}

TEST(SplineFaces, OverPlanesAreExactToo) {
  const geometry::Brep solid = test::wavy_top_over_planes(uneven(3, {0.1, 0.2, 0.35, 0.5, 0.6, 0.8, 0.9}));
  const Parameterization made = parameterize(hex_model({{solid, "block"}}));
  expect_exact(made, solid.volume());
  EXPECT_EQ(made.report.rounds, 0);
}

TEST(SplineFaces, SurviveAStepFile) {
  const auto path = std::filesystem::temp_directory_path() / "isopatch_wavy_top.step";
  const geometry::Brep solid = test::wavy_top_over_planes(uneven(3, {0.1, 0.2, 0.35, 0.5, 0.6, 0.8, 0.9}));
  geometry::write_brep(path, solid);
  const Parameterization made = parameterize(read_blocks({.files = {path}}).model);
  std::filesystem::remove(path);
  expect_exact(made, solid.volume());
}

TEST(SplineFaces, TwoBlocksThatShareOneHaveTheKnotsOfBoth) {
  // Both meet in x = 0 and have other knots along x; the second one's directions are others.
  const KnotVector y = uneven(3, {0.2, 0.6}), z = uneven(2, {0.5});
  const auto map = [](const Eigen::Vector3d& p) { return wave({p[0] / 2, p[1], p[2]}); };
  const NurbsVolume first = test::bent({uneven(3, {0.7}), y, z}, [&](const Eigen::Vector3d& p) {
    return map({p[0] - 1, p[1], p[2]});
  });
  const NurbsVolume second = test::bent({z, uneven(2, {0.3, 0.9}), y}, [&](const Eigen::Vector3d& p) {
    return map({p[1], p[2], p[0]});
  });
  const Parameterization made =
      parameterize(hex_model({{test::solid_of(first), "first"}, {test::solid_of(second), "second"}}));
  ASSERT_EQ(made.patches.interfaces.size(), 1u);
  expect_exact(made, geometry::volume(first) + geometry::volume(second));
  EXPECT_EQ(test::coincident_but_different_points(made.patches), 0);
}

// Twenty spans of a face that three tell to the tolerance would go through all patches around.
TEST(SplineFaces, WithManyMoreKnotsThanTheToleranceNeedsAreFitted) {
  const NurbsVolume plain = test::bent({KnotVector::bezier(3), uneven(1, {}), uneven(1, {})}, wave);
  const NurbsVolume given =
      geometry::refined(plain, {KnotVector::uniform(3, 20), KnotVector::bezier(1), KnotVector::bezier(1)});
  const HexModel model = hex_model({{test::solid_of(given), "block"}});
  const Parameterization made = parameterize(model);
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  EXPECT_LE(made.report.worst_face().deviation, made.report.tolerance);
  EXPECT_LT(made.patches.patches[0].knots(0).element_count(), 14);
  ParameterizationOptions options;
  options.fit.tolerance = 1e-8;
  expect_exact(parameterize(model, options), geometry::volume(given));
}

// Twelve spans are worth it where eight are needed, but not one of a thousandth: it would go through all
// around.
TEST(SplineFaces, WithKnotsThatNearlyMeetAreFitted) {
  const NurbsVolume plain = test::bent({KnotVector::uniform(3, 8), uneven(1, {}), uneven(1, {})}, wave);
  const auto shortest_span = [](const Parameterization& made) {
    double shortest = 1;
    const std::vector<double> breaks = made.patches.patches[0].knots(0).breaks();
    for (std::size_t i = 1; i < breaks.size(); ++i) shortest = smaller(shortest, breaks[i] - breaks[i - 1]);
    return shortest;
  };
  for (const double beside : {0.06, 0.001}) {
    const NurbsVolume given = geometry::refined(
        plain, {geometry::with_knots(plain.knots(0), {0.5 + beside}), plain.knots(1), plain.knots(2)});
    const HexModel model = hex_model({{test::solid_of(given), "block"}});
    const Parameterization made = parameterize(model);
    EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
    EXPECT_LE(made.report.worst_face().deviation, made.report.tolerance);
    if (beside > 0.01)
      expect_exact(made, geometry::volume(given));
    else
      EXPECT_GT(shortest_span(made), 0.01);
  }
}

// Its speed falls to nothing at an end: such a pace would make det J zero there.
TEST(SplineFaces, WithPacesThatStopAreRunThroughByArcLength) {
  NurbsVolume given = test::bent({KnotVector::bezier(3), uneven(1, {}), uneven(1, {})}, wave);
  Eigen::Matrix3Xd points = given.control_points();
  for (Eigen::Index i = 0; i < points.cols(); i += 4) points.col(i + 1) = points.col(i);
  given = {given.knots(), points};
  const Parameterization made = parameterize(hex_model({{test::solid_of(given), "block"}}));
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
}

// Along y the top runs from slow to fast, eight times as fast: exact, but skew against the bottom.
TEST(SplineFaces, GiveWayToArcLengthWhereThatMakesBetterPatches) {
  const NurbsVolume given = test::bent({uneven(1, {}), KnotVector::bezier(3), uneven(1, {})},
                                       [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
                                         const double y = p[1], slow = y * y * (0.8 + 0.2 * y) + 0.05 * y;
                                         return {p[0], p[2] > 0.5 ? slow : 1.05 * y, 0.3 * p[2]};
                                       });
  const HexModel model = hex_model({{test::solid_of(given), "block"}});
  ParameterizationOptions options;
  options.optimize = false;
  const double kept = parameterize(model, options).report.patches[0].quality.min_scaled_jacobian;
  options.wanted_quality = 0.98;
  const double other = parameterize(model, options).report.patches[0].quality.min_scaled_jacobian;
  EXPECT_LT(kept, 0.95);
  EXPECT_GT(other, 0.98);
}

TEST(Sense, OfABlockThatWindsIsThatOfItsSolid) {
  const NurbsVolume given = test::bent({KnotVector::uniform(3, 96), uneven(1, {}), uneven(1, {})},
                                       [](const Eigen::Vector3d& p) { return test::helix(p, 6); });
  const Parameterization made = parameterize(hex_model({{test::solid_of(given), "spring"}}));
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  EXPECT_GT(made.report.patches[0].quality.min_scaled_jacobian, 0.8);
  EXPECT_NEAR(made.report.patches[0].volume, std::abs(geometry::volume(given)),
              1e-3 * made.report.patches[0].volume);
}

// Of degree 5, so that its knots cannot be kept: twelve half turns need 96 spans of degree 3, more than
// `max_spans`.
TEST(Sense, TurnsMayHaveMoreSpansThanAStraightBlock) {
  const NurbsVolume given = test::bent({KnotVector::uniform(5, 48), uneven(1, {}), uneven(1, {})},
                                       [](const Eigen::Vector3d& p) { return test::helix(p, 6); });
  const Parameterization made = parameterize(hex_model({{test::solid_of(given), "spring"}}));
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  EXPECT_GT(made.patches.patches[0].knots()[0].element_count() +
                made.patches.patches[0].knots()[1].element_count() +
                made.patches.patches[0].knots()[2].element_count(),
            90);
  EXPECT_LT(made.report.worst_face().off_edges, 1e-6 * made.report.size);
}

}  // namespace
}  // namespace isopatch::segmentation
