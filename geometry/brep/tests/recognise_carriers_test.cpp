#include "geometry/brep/recognise_carriers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/check_brep.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/brep/write_brep.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

std::map<SurfaceKind, int> kinds_of(const Brep& brep) {
  std::map<SurfaceKind, int> result;
  for (const BrepFace& face : brep.faces()) ++result[face.kind];
  return result;
}

std::map<CurveKind, int> curve_kinds_of(const Brep& brep) {
  std::map<CurveKind, int> result;
  for (const BrepEdge& edge : brep.edges()) ++result[edge.kind];
  return result;
}

/// Faces, edges and vertices are where they were, under their numbers.
void expect_same_shape(const Brep& before, const Brep& after) {
  ASSERT_EQ(before.faces().size(), after.faces().size());
  ASSERT_EQ(before.edges().size(), after.edges().size());
  ASSERT_EQ(before.vertices(), after.vertices());
  // Ellipses in the domains of cylinders are interpolated.
  const double near = 1e-9 * before.size();
  for (int f = 0; f < static_cast<int>(before.faces().size()); ++f) {
    const FaceId id(f);
    SCOPED_TRACE(f);
    EXPECT_EQ(before.face(id).name, after.face(id).name);
    EXPECT_EQ(before.face(id).colour, after.face(id).colour);
    EXPECT_EQ(before.face(id).loops, after.face(id).loops);
    EXPECT_NEAR(before.area(id), after.area(id), 1e-8 * before.area(id));
    for (const auto& loop : after.face(id).loops)
      for (const EdgeUse& use : loop)
        for (const double t : {0.0, 0.2, 0.7, 1.0}) {
          const Eigen::Vector2d uv = after.domain_point(id, use, t);
          EXPECT_LT((after.point(id, uv) - after.point(use.edge, t)).norm(), near);
          EXPECT_GT(after.outward_normal(id, uv).dot(
                        before.outward_normal(id, before.project(id, after.point(id, uv)).uv)),
                    0.999);
        }
  }
  for (int e = 0; e < static_cast<int>(before.edges().size()); ++e) {
    const EdgeId id(e);
    EXPECT_EQ(before.edge(id).start, after.edge(id).start);
    EXPECT_EQ(before.edge(id).end, after.edge(id).end);
    for (const double t : {0.0, 0.3, 1.0}) EXPECT_LT(before.project(id, after.point(id, t)).distance, near);
  }
}

class Disguised : public testing::TestWithParam<std::string> {};

TEST_P(Disguised, SolidsAreWhatTheyWere) {
  const Brep original = test::made_brep(GetParam());
  const Brep splines = test::made_brep(GetParam() + "_splines");
  ASSERT_EQ(kinds_of(splines).count(SurfaceKind::plane), 0u);
  const RecognisedBrep found = recognise_carriers(splines);
  expect_same_shape(splines, found.brep);
  std::map<SurfaceKind, int> expected = kinds_of(original);
  // What was turned may be a torus that is called a surface of revolution.
  if (expected.count(SurfaceKind::other) > 0) {
    expected[SurfaceKind::torus] += expected[SurfaceKind::other];
    expected.erase(SurfaceKind::other);
  }
  EXPECT_EQ(kinds_of(found.brep), expected);
  EXPECT_EQ(curve_kinds_of(found.brep), curve_kinds_of(original));
  EXPECT_NEAR(found.brep.volume(), original.volume(), 1e-9 * original.volume());
  EXPECT_FALSE(found.text().empty());
  EXPECT_TRUE(check(found.brep).contradictions.empty());
  EXPECT_EQ(check(found.brep).stage, check(original).stage);
}

INSTANTIATE_TEST_SUITE_P(Solids, Disguised,
                         testing::Values("drilled", "cylinder", "cone", "sphere", "torus", "grooved",
                                         "round_corner", "oblique_ring", "elbow_piece"),
                         [](const auto& info) { return info.param; });

TEST(RecogniseCarriers, SaysWhatItFound) {
  EXPECT_EQ(recognise_carriers(test::made_brep("drilled_splines")).text(),
            "7 spline faces are planes and cylinders");
  EXPECT_EQ(recognise_carriers(test::made_brep("sphere_splines")).text(), "1 spline face is a sphere");
  EXPECT_EQ(recognise_carriers(test::made_brep("drilled")).text(), "");
}

TEST(RecogniseCarriers, LeavesOthersAlone) {
  for (const char* name : {"block", "drilled", "sphere"}) {
    const Brep given = test::made_brep(name);
    EXPECT_EQ(&recognise_carriers(given).brep.kernel(), &given.kernel()) << name;
  }
  // The coil is a spline, its two ends are planes.
  const RecognisedBrep spring = recognise_carriers(test::made_brep("spring"));
  EXPECT_GT(kinds_of(spring.brep)[SurfaceKind::spline], 0);
}

TEST(RecogniseCarriers, WantsTheWholeFaceToAgree) {
  // A hill of 1e-6 of the size.
  std::vector<TrimmedSurface> faces = trimmed_surfaces(test::made_brep("block"));
  NurbsSurface& top = faces[0].surface;
  top = insert_knots(elevate_degree(elevate_degree(top, 0, 1), 1, 1), 0, {top.low()[0] + 1e-3});
  Eigen::Matrix3Xd points = top.control_points();
  const Eigen::Vector3d normal =
      (points.col(1) - points.col(0)).cross(points.col(points.cols() - 1) - points.col(0)).normalized();
  points.col(points.cols() / 2) += 1e-7 * normal;
  top = NurbsSurface(top.knots(), points);
  const Brep hilly = sew(faces).brep;
  const RecognisedBrep found = recognise_carriers(hilly);
  EXPECT_EQ(kinds_of(found.brep)[SurfaceKind::plane], 5);
  EXPECT_EQ(found.brep.faces()[0].kind, SurfaceKind::spline);
  EXPECT_EQ(recognise_carriers(hilly, 1e-4).text(), "6 spline faces are planes");
  EXPECT_ERROR(recognise_carriers(hilly, 1), ErrorCode::invalid_argument, "tolerance");
}

TEST(RecogniseCarriers, ComesOutOfAFileAgain) {
  const Brep found = recognise_carriers(test::made_brep("round_corner_splines")).brep;
  const auto path = std::filesystem::temp_directory_path() / "isopatch_recognised.step";
  write_brep(path, found);
  const std::string text = read_file(path);
  const Brep again(brep_module().read({.path = path, .text = text}, {}).bodies.front().kernel);
  std::filesystem::remove(path);
  EXPECT_EQ(kinds_of(again), kinds_of(found));
  EXPECT_NEAR(again.volume(), found.volume(), 1e-9 * found.volume());
}

}  // namespace
}  // namespace isopatch::geometry
