// Sides on planes, cylinders, cones, spheres and tori are exact, and patches have few control points.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/measures.hpp"
#include "geometry/multi_patch.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/internal/exact_curve.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/parameterization/tests/checks.hpp"

namespace isopatch::segmentation {
namespace {

constexpr double circle = std::numbers::pi;

double mm3(double volume) {
  return 1e-9 * volume;
}

Parameterization patches_of(const std::string& made_solid, int degree = 3) {
  const ReadBlocks read = read_blocks({.files = {geometry::test::made_solid(made_solid)}});
  ParameterizationOptions options;
  options.fit.degree = degree;
  return parameterize(read.model, options);
}

/// The model is usable, its sides are exact, its volume is `volume` (mm^3), and each patch has one element.
void expect_exact_volume(const Parameterization& made, double volume, int control_points) {
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  EXPECT_LT(made.report.worst_face().deviation, 1e-12 * made.report.size) << made.report.worst_face().name;
  double sum = 0;
  for (const PatchReport& patch : made.report.patches) {
    sum += patch.volume;
    EXPECT_EQ(patch.control_points, control_points) << patch.name;
  }
  EXPECT_NEAR(sum, mm3(volume), 1e-10 * mm3(volume));
}

TEST(ExactFaces, ABoredBlockInFour) {
  const Parameterization made = patches_of("drilled_quarters");
  ASSERT_EQ(made.patches.patches.size(), 4u);
  expect_exact_volume(made, 30 * 20 * 10 - circle * 25 * 10, 64);
  expect_exact_volume(patches_of("drilled_quarters", 2), 30 * 20 * 10 - circle * 25 * 10, 27);
}

TEST(ExactFaces, NeighboursShareControlPointsAndWeights) {
  const Parameterization made = patches_of("drilled_quarters");
  ASSERT_EQ(made.patches.interfaces.size(), 4u);
  EXPECT_EQ(test::coincident_but_different_points(made.patches), 0);
  const geometry::MultiPatch model = geometry::connect(made.patches);
  EXPECT_EQ(model.interfaces().size(), 4u);
  for (const geometry::Interface& face : model.interfaces()) EXPECT_LT(face.gap, 1e-15);
}

TEST(ExactFaces, ARing) {
  const double ring = circle * (64 - 25) * 4;
  expect_exact_volume(patches_of("ring_quarter"), ring / 4, 64);
  // More than 120 degrees: a knot, where the patch is as smooth as a polygon of its weights.
  expect_exact_volume(patches_of("ring_150"), ring * 150 / 360, 7 * 16);
}

// The plane cuts ellipses out of the cylinders: mean height 6 plus what the centre of area adds.
TEST(ExactFaces, ARingUnderAnObliquePlane) {
  const double from = circle / 18, to = from + circle / 2;
  const double area = circle / 4 * (64 - 25), moment = (512 - 125) / 3.0;
  const double x = moment * (std::sin(to) - std::sin(from)), y = moment * (std::cos(from) - std::cos(to));
  expect_exact_volume(patches_of("oblique_ring"), 6 * area + x / 4 + y / 8, 64);
}

TEST(ExactFaces, AConicalRing) {
  const double outer = circle * 5 / 3 * (64 + 32 + 16), inner = circle * 5 / 3 * (36 + 18 + 9);
  expect_exact_volume(patches_of("cone_quarter"), (outer - inner) / 4, 64);
}

TEST(ExactFaces, AShellAwayFromThePole) {
  const double height = std::sin(circle / 3) - std::sin(circle / 18);
  expect_exact_volume(patches_of("shell_piece"), 2 * circle / 3 * (343 - 125) * height / 4, 64);
}

TEST(ExactFaces, AnElbow) {
  // Pappus: the area turned by 60 degrees at the distance of its centre.
  const double area = circle / 4 * 3, moment = 6 * area + 7.0 / 3;
  expect_exact_volume(patches_of("elbow_piece"), circle / 3 * moment, 64);
}

TEST(ExactCurve, OfAnArcHasTheCosineOfHalfItsAngle) {
  const geometry::Brep ring = geometry::test::made_brep("ring_quarter");
  int arcs = 0;
  for (int e = 0; e < static_cast<int>(ring.edges().size()); ++e) {
    const auto exact = exact_curve(ring, EdgeId(e));
    EXPECT_EQ(exact.has_value(), ring.edge(EdgeId(e)).kind == geometry::CurveKind::circle);
    if (!exact) continue;
    ++arcs;
    EXPECT_EQ(exact->curve.size(), 3);
    EXPECT_NEAR(exact->curve.weights()[1], std::sqrt(0.5), 1e-14);
    const ExactCurve back = reversed(*exact);
    for (const double u : {0.1, 0.4, 0.8}) {
      const Eigen::Vector3d point = exact->curve.point(geometry::Parameter<1>(u));
      EXPECT_LT((point - ring.point(EdgeId(e), exact->pace(u))).norm(), 1e-16);
      EXPECT_LT((back.curve.point(geometry::Parameter<1>(1 - u)) - point).norm(), 1e-16);
      EXPECT_NEAR(back.pace(1 - u), 1 - exact->pace(u), 1e-14);
    }
  }
  EXPECT_EQ(arcs, 4);
}

}  // namespace
}  // namespace isopatch::segmentation
