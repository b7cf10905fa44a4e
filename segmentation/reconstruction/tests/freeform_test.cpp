#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "geometry/brep/check_brep.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "segmentation/reconstruction/internal/fit_curves.hpp"
#include "segmentation/reconstruction/internal/slide_rulings.hpp"
#include "segmentation/reconstruction/internal/split_bands.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"

namespace isopatch::segmentation {
namespace {

constexpr int around = 96;
constexpr double height = 0.4;

/// A closed curve without straight or circular parts.
Eigen::Vector3d outline(int i, double scale, double z) {
  const double turn = 2 * std::numbers::pi * i / around, radius = scale * (1 + 0.15 * std::cos(3 * turn));
  return {radius * std::cos(turn), radius * std::sin(turn), z};
}

/// Enclosed by the outline of scale 1: the integral of radius^2 / 2.
constexpr double outline_area = std::numbers::pi * (1 + 0.15 * 0.15 / 2);

/// A post over the outline, whose top is larger or smaller by a factor.
geometry::TriangleMesh post(double top) {
  geometry::TriangleMesh mesh;
  mesh.vertices.resize(3, 2 * around + 2);
  mesh.triangles.resize(3, 4 * around);
  for (int i = 0; i < around; ++i) {
    mesh.vertices.col(i) = outline(i, 1, 0);
    mesh.vertices.col(around + i) = outline(i, top, height);
    const int next = (i + 1) % around;
    mesh.triangles.col(4 * i) << i, next, around + next;
    mesh.triangles.col(4 * i + 1) << i, around + next, around + i;
    mesh.triangles.col(4 * i + 2) << next, i, 2 * around;
    mesh.triangles.col(4 * i + 3) << around + i, around + next, 2 * around + 1;
  }
  mesh.vertices.col(2 * around) << 0, 0, 0;
  mesh.vertices.col(2 * around + 1) << 0, 0, height;
  return mesh;
}

int freeform_faces(const Reconstruction& made) {
  return static_cast<int>(std::count_if(made.regions.regions.begin(), made.regions.regions.end(),
                                        [](const Region& region) { return region.spline.has_value(); }));
}

class Post : public testing::TestWithParam<double> {};

TEST_P(Post, WithFreeformWallsComesBackFromItsTriangles) {
  const double top = GetParam();
  const Reconstruction made = reconstruct(post(top));
  EXPECT_GE(freeform_faces(made), 2);
  EXPECT_EQ(static_cast<int>(made.brep.faces().size()), freeform_faces(made) + 2);
  // Scaled outlines over a height: the mean of their areas by Simpson's rule. A wall that is not upright is
  // known between its edges within the chord error alone.
  const double volume = height * outline_area * (1 + top + top * top) / 3;
  const double chord = std::abs(made.report.mesh_volume / volume - 1);
  EXPECT_NEAR(made.brep.volume() / volume, 1, top == 1 ? 2e-5 : chord);
  const geometry::BrepReport report = geometry::check(made.brep);
  EXPECT_TRUE(report.contradictions.empty());
  EXPECT_EQ(report.topology.genus, 0);
  EXPECT_LT(made.report.largest_deviation, 3e-5 * made.brep.size());
}

INSTANTIATE_TEST_SUITE_P(Freeform, Post, testing::Values(1.0, 0.9, 1.2),
                         [](const auto& test) { return "Top" + std::to_string(int(100 * test.param)); });

TEST(Freeform, WallsAtRightAnglesAreUprightToRoundOff) {
  const Reconstruction made = reconstruct(post(1));
  for (std::size_t f = 0; f < made.regions.regions.size(); ++f) {
    if (!made.regions.regions[f].spline) continue;
    const FaceId face(static_cast<int>(f));
    const geometry::DomainBox box = made.brep.domain(face);
    for (const double share : {0.1, 0.37, 0.8})
      EXPECT_LT(std::abs(made.brep.outward_normal(face, box.low + share * (box.high - box.low)).z()), 1e-9);
  }
}

TEST(FitCurves, FollowAPolynomialWithoutAKnotAndHalveThemWhereTheyMust) {
  CurveSample cubic{Eigen::VectorXd::LinSpaced(20, 0, 1), Eigen::Matrix3Xd(3, 20)};
  CurveSample wave = cubic;
  for (Eigen::Index i = 0; i < 20; ++i) {
    const double t = cubic.t[i];
    cubic.points.col(i) << t, t * t, t * t * t;
    wave.points.col(i) << t, std::sin(6 * t), 0;
  }
  const FittedCurves one = fit_curves({cubic}, 1e-6);
  EXPECT_EQ(one.curves[0].size(), 4);
  EXPECT_LT(one.largest, 1e-8);
  const FittedCurves both = fit_curves({cubic, wave}, 1e-3);
  EXPECT_GT(both.curves[1].size(), 4);
  EXPECT_EQ(both.curves[0].knots(), both.curves[1].knots());
  EXPECT_LE(both.largest, 1e-3);
  EXPECT_EQ(both.curves[1].control_points().row(2).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 0);
}

TEST(SlideRulings, PassThroughPointsInside) {
  // Lines between two arcs whose ends belong together otherwise than by length.
  const auto arc = [](double t, double z) { return Eigen::Vector3d(std::sin(t), std::cos(t) + 0.5 * z, z); };
  const auto other = [](double s) { return s + 0.08 * std::sin(std::numbers::pi * s); };
  CurveSample low{Eigen::VectorXd::LinSpaced(25, 0, 1), Eigen::Matrix3Xd(3, 25)}, high = low;
  RuledPoints points{Eigen::Matrix3Xd(3, 75), Eigen::VectorXd(75), Eigen::Vector3d::UnitZ()};
  for (Eigen::Index i = 0; i < 25; ++i) {
    const double s = low.t[i];
    low.points.col(i) = arc(s, 0);
    high.points.col(i) = arc(s, 1);
    points.points.col(i) = arc(s, 0);
    points.points.col(25 + i) = arc(s, 1);
    points.points.col(50 + i) = (arc(s, 0) + arc(other(s), 1)) / 2;
  }
  points.v << Eigen::VectorXd::Zero(25), Eigen::VectorXd::Ones(25), Eigen::VectorXd::Constant(25, 0.5);
  const FittedCurves start = fit_curves({low, high}, 1e-6);
  const RuledCurves slid = slide_rulings({start.curves[0], start.curves[1]}, points, 1e-5);
  EXPECT_LT(slid.largest_on_curves, 1e-5);
  // By length the points inside are off by 0.08^2 / 8 = 8e-4.
  EXPECT_LT(slid.largest, 1e-4);
}

TEST(SplitBands, DivideAClosedWallIntoDiscs) {
  const geometry::TriangleMesh mesh = post(0.9);
  Regions regions;
  regions.regions.resize(3);
  for (int t = 0; t < mesh.triangles.cols(); ++t) {
    const int region = t % 4 < 2 ? 0 : t % 4 - 1;
    regions.regions[static_cast<std::size_t>(region)].triangles.push_back(t);
    regions.of_triangle.push_back(region);
  }
  for (const std::size_t plane : {1u, 2u}) regions.regions[plane].carrier = geometry::Carrier{};
  const Regions split = split_bands(mesh, geometry::neighbours(mesh), regions);
  ASSERT_GE(split.regions.size(), 4u);
  std::size_t triangles = 0;
  for (const Region& region : split.regions)
    if (!region.carrier) triangles += region.triangles.size();
  EXPECT_EQ(triangles, 2u * around);
  EXPECT_EQ(std::set<int>(split.of_triangle.begin(), split.of_triangle.end()).size(), split.regions.size());
}

}  // namespace
}  // namespace isopatch::segmentation
