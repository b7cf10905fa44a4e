#include "geometry/brep/make_brep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/check_brep.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

using testing::HasSubstr;

/// The faces of a polyhedron of quadrilaterals as bilinear surfaces over the unit square.
std::vector<TrimmedSurface> bilinear_faces(const Polyhedron& solid) {
  const std::vector<Eigen::Vector3d> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::vector<TrimmedSurface> faces;
  for (const auto& face : solid.faces) {
    TrimmedSurface surface;
    Eigen::Matrix3Xd points(3, 4);
    points << solid.vertices.col(face[0]), solid.vertices.col(face[1]), solid.vertices.col(face[3]),
        solid.vertices.col(face[2]);
    surface.surface = NurbsSurface({KnotVector(), KnotVector()}, points);
    surface.name = "side " + std::to_string(faces.size());
    surface.loops.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      Eigen::Matrix3Xd ends(3, 2);
      ends << square[i], square[(i + 1) % 4];
      surface.loops[0].emplace_back(NurbsCurve::KnotVectors{KnotVector()}, ends);
    }
    faces.push_back(std::move(surface));
  }
  return faces;
}

TEST(MakeBrep, PolyhedraHaveTheirVolumeAreaAndCounts) {
  std::vector<Polyhedron> solids = {test::block(1, 2, 3), test::l_shape(), test::triangulated_torus(7, 5)};
  for (int n = 3; n < 9; ++n) solids.insert(solids.end(), {test::prism(n, 0.01 * n), test::pyramid(n, 100)});
  for (unsigned seed = 0; seed < 20; ++seed)
    solids.push_back(test::random_hull(5 + static_cast<int>(seed), seed));
  for (const Polyhedron& solid : solids) {
    const Brep brep = make_brep(solid);
    EXPECT_EQ(brep.faces().size(), solid.faces.size());
    EXPECT_EQ(brep.vertices().cols(), solid.vertices.cols());
    EXPECT_EQ((brep.vertices() - solid.vertices).norm(), 0);
    EXPECT_NEAR(brep.volume(), test::polyhedron_volume(solid), 1e-12 * brep.volume());
    EXPECT_NEAR(brep.area(), test::polyhedron_area(solid), 1e-12 * brep.area());
    const BrepReport report = check(brep);
    const auto euler =
        static_cast<int>(solid.vertices.cols() + static_cast<Eigen::Index>(solid.faces.size())) -
        static_cast<int>(brep.edges().size());
    EXPECT_EQ(report.topology.euler_characteristic, euler);
    EXPECT_EQ(report.topology.genus, 1 - euler / 2);
  }
}

TEST(MakeBrep, ConvexSolidsHaveConvexEdgesAndAPlanarGraph) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const BrepReport report =
        check(make_brep(test::random_hull(12, seed)), {.angles = {.flat = Angle::degrees(1e-4)}});
    EXPECT_EQ(report.count(Convexity::convex), static_cast<int>(report.angles.size()));
    EXPECT_TRUE(report.connectivity.three_connected);
    EXPECT_EQ(report.stage, BrepStage::decomposition);
  }
}

TEST(MakeBrep, AnglesAreThoseOfRegularPrisms) {
  for (int n = 3; n < 8; ++n) {
    const Brep brep = make_brep(test::prism(n));
    const BrepReport report = check(brep);
    int upright = 0;
    for (std::size_t e = 0; e < brep.edges().size(); ++e) {
      const bool vertical = std::abs(brep.tangent(EdgeId(static_cast<int>(e)), 0.5).z()) > 0.5;
      const double expected = vertical ? 180.0 * (n - 2) / n : 90.0;
      EXPECT_NEAR(report.angles[e].smallest.degrees(), expected, 1e-9);
      EXPECT_NEAR(report.angles[e].largest.degrees(), expected, 1e-9);
      upright += vertical;
    }
    EXPECT_EQ(upright, n);
  }
}

TEST(MakeBrep, TheInnerEdgeOfAnLIsNotConvex) {
  const Brep brep = make_brep(test::l_shape());
  const BrepReport report = check(brep);
  ASSERT_EQ(report.count(Convexity::non_convex), 1);
  for (std::size_t e = 0; e < report.angles.size(); ++e)
    if (report.angles[e].convexity == Convexity::non_convex) {
      EXPECT_NEAR(report.angles[e].largest.degrees(), 270, 1e-9);
      EXPECT_LT((brep.point(EdgeId(static_cast<int>(e)), 0.5) - Eigen::Vector3d(1, 1, 0.5)).norm(), 1e-12);
    }
  EXPECT_THAT(report.findings, testing::Contains(HasSubstr("1 non-convex edge")));
}

TEST(MakeBrep, PolyhedraTurnedInsideOutAreTurnedBack) {
  Polyhedron solid = test::prism(5);
  for (auto& face : solid.faces) std::reverse(face.begin(), face.end());
  EXPECT_NEAR(make_brep(solid).volume(), -test::polyhedron_volume(solid), 1e-12);
  std::reverse(solid.faces[2].begin(), solid.faces[2].end());
  EXPECT_NEAR(make_brep(solid).volume(), test::polyhedron_volume(test::prism(5)), 1e-12);
}

TEST(MakeBrep, QuadrilateralsNeedNotBePlane) {
  Polyhedron solid = test::block(1, 1, 1);
  solid.vertices.col(7) += Eigen::Vector3d(0.2, 0.1, 0.3);
  const Brep brep = make_brep(solid);
  EXPECT_EQ(brep.faces()[1].kind, SurfaceKind::spline);
  EXPECT_EQ(brep.faces()[0].kind, SurfaceKind::plane);
  EXPECT_TRUE(check(brep).boundary.bounds_a_solid());
  EXPECT_EQ(check(brep).stage, BrepStage::parameterization);
  EXPECT_LT(check(brep).largest_gap, 1e-14);
}

TEST(MakeBrep, SmoothSurfacesPassSixCornersThatAreNotPlane) {
  Polyhedron solid = test::prism(6);
  solid.vertices(2, 0) += 0.2;
  const Brep brep = make_brep(solid);
  EXPECT_EQ(std::count_if(brep.faces().begin(), brep.faces().end(),
                          [](const BrepFace& face) { return face.kind == SurfaceKind::spline; }),
            1);
  EXPECT_TRUE(check(brep).boundary.bounds_a_solid());
  EXPECT_LT(check(brep).largest_gap, 1e-6);
  EXPECT_NEAR(brep.volume(), test::polyhedron_volume(test::prism(6)), 0.2);
}

TEST(MakeBrep, BrokenPolyhedraAreRefusedByName) {
  Polyhedron open = test::block(1, 2, 3);
  open.faces.pop_back();
  EXPECT_THAT(isopatch::test::message_of([&] { make_brep(open); }),
              testing::AllOf(HasSubstr("not_manifold"), HasSubstr("vertex 1 at (1, 0, 0)"),
                             HasSubstr("one face only")));

  Polyhedron wall = test::block(1, 2, 3);
  wall.faces.push_back({0, 1, 7, 6});
  EXPECT_THAT(isopatch::test::message_of([&] { make_brep(wall); }), HasSubstr("more than two faces"));

  Polyhedron short_edge = test::block(1, 2, 3);
  short_edge.vertices.col(1) = short_edge.vertices.col(0);
  EXPECT_THAT(isopatch::test::message_of([&] { make_brep(short_edge); }),
              testing::AllOf(HasSubstr("has no length"), HasSubstr("vertex 1 at (0, 0, 0)")));

  Polyhedron crooked = test::prism(6);
  crooked.vertices.col(0) = crooked.vertices.col(3) +
                            Eigen::Vector3d(-0.1, 0, 0.2);  // as seen from above, its outline crosses itself
  EXPECT_THAT(isopatch::test::message_of([&] { make_brep(crooked); }), HasSubstr("is not plane"));

  Polyhedron touching;  // two tetrahedra with a common vertex
  touching.vertices =
      (Eigen::Matrix3Xd(3, 7) << 0, 1, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1, 1, 1, 0, -1, -1, -1)
          .finished();
  touching.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {3, 5, 4}, {3, 4, 6}, {4, 5, 6}, {5, 3, 6}};
  EXPECT_THAT(isopatch::test::message_of([&] { make_brep(touching); }),
              HasSubstr("touches itself in vertex"));

  const BrepReport report = check(make_brep(open, {.accept_open = true}));
  EXPECT_EQ(report.stage, BrepStage::repair);
  EXPECT_EQ(report.count(Convexity::free), 4);
}

TEST(Sew, FacesOfABlockFindTheirCommonEdges) {
  const Polyhedron solid = test::block(3, 2, 1);
  const SewnBrep sewn = sew(bilinear_faces(solid));
  EXPECT_EQ(sewn.brep.edges().size(), 12u);
  EXPECT_EQ(sewn.brep.vertices().cols(), 8);
  EXPECT_LT(sewn.largest_correction, 1e-14);
  EXPECT_NEAR(sewn.brep.volume(), 6, 1e-12);
  EXPECT_EQ(sewn.brep.faces()[4].name, "side 4");
  EXPECT_EQ(check(sewn.brep).stage, BrepStage::parameterization);
}

TEST(Sew, OrderAndSenseOfTheSurfacesDoNotMatter) {
  std::vector<TrimmedSurface> faces = bilinear_faces(test::block(3, 2, 1));
  // One surface turned around: its u runs the other way.
  Eigen::Matrix3Xd points = faces[3].surface.control_points();
  points.col(0).swap(points.col(1));
  points.col(2).swap(points.col(3));
  faces[3].surface = NurbsSurface(faces[3].surface.knots(), points);
  EXPECT_NEAR(sew(faces).brep.volume(), 6, 1e-12);
}

TEST(Sew, SmallGapsAreClosedAndReported) {
  const double size = std::sqrt(14.0), gap = 5e-5 * size;
  std::vector<TrimmedSurface> faces = bilinear_faces(test::block(3, 2, 1));
  Eigen::Matrix3Xd points = faces[1].surface.control_points();
  points.row(2).array() += gap;
  faces[1].surface = NurbsSurface(faces[1].surface.knots(), points);
  const SewnBrep sewn = sew(faces);
  EXPECT_NEAR(sewn.largest_correction, gap, 0.01 * gap);
  EXPECT_NEAR(check(sewn.brep).largest_gap, gap, 0.01 * gap);
  EXPECT_NEAR(sewn.brep.volume(), 6, 6 * gap);
}

TEST(Sew, LargeGapsAreRefusedByName) {
  std::vector<TrimmedSurface> faces = bilinear_faces(test::block(3, 2, 1));
  Eigen::Matrix3Xd points = faces[1].surface.control_points();
  points.row(2).array() += 0.1;
  faces[1].surface = NurbsSurface(faces[1].surface.knots(), points);
  EXPECT_THAT(isopatch::test::message_of([&] { sew(faces); }),
              testing::AllOf(HasSubstr("not_manifold"), HasSubstr("belongs to one face only"),
                             HasSubstr("curve"), HasSubstr("0.1 m away")));
  EXPECT_FALSE(check(sew(faces, {.accept_open = true}).brep).boundary.closed());
}

TEST(Sew, LoopsThatDoNotCloseAndCurvesWithoutLengthAreRefused) {
  std::vector<TrimmedSurface> faces = bilinear_faces(test::block(3, 2, 1));
  std::vector<TrimmedSurface> broken = faces;
  broken[2].loops[0].pop_back();
  EXPECT_THAT(isopatch::test::message_of([&] { sew(broken); }),
              testing::AllOf(HasSubstr("face 2"), HasSubstr("loops must close")));
  broken = faces;
  broken[5].loops[0].emplace_back(NurbsCurve::KnotVectors{KnotVector()}, Eigen::Matrix3Xd::Zero(3, 2));
  EXPECT_THAT(isopatch::test::message_of([&] { sew(broken); }),
              testing::AllOf(HasSubstr("face 5"), HasSubstr("has no length")));
  broken = faces;
  broken.push_back(faces[0]);
  EXPECT_THAT(isopatch::test::message_of([&] { sew(broken); }), HasSubstr("more than two faces"));
  broken = faces;
  broken[3].loops.clear();
  EXPECT_ERROR(sew(broken, {.accept_open = true}), ErrorCode::invalid_argument, "face 3 has no loop");
  EXPECT_THAT(isopatch::test::message_of([&] { sew(faces, {.same_curve = 0.1}); }),
              HasSubstr("same_curve is 0.1"));
}

}  // namespace
}  // namespace isopatch::geometry
