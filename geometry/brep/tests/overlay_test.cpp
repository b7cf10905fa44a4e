#include "geometry/brep/overlay.hpp"

#include <gtest/gtest.h>

#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::geometry {
namespace {

std::vector<FaceId> floors(const Brep& solid) {
  std::vector<FaceId> result;
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f)
    if (const auto carrier = solid.carrier(FaceId(f));
        carrier && carrier->kind == SurfaceKind::plane && std::abs(carrier->axis.z()) > 0.9)
      result.emplace_back(f);
  return result;
}

TEST(Overlay, DrawsTheFloorsOfAStackOverEachOther) {
  // A plate of 30 by 20 with a boss of radius 6 and a bore of radius 3: three floors, two regions.
  const Brep solid = test::made_brep("bored_boss");
  const std::vector<FaceId> faces = floors(solid);
  ASSERT_EQ(faces.size(), 3U);
  const Overlay laid = overlay(solid, faces, {0, 0, 0.5}, {0, 0, 1});
  ASSERT_EQ(laid.sheet.faces().size(), 2U);
  const double pi = 3.14159265358979323846;
  for (int f = 0; f < 2; ++f) {
    const bool ring = laid.sheet.area(FaceId(f)) < 2e-4;
    EXPECT_NEAR(laid.sheet.area(FaceId(f)), ring ? 27e-6 * pi : 600e-6 - 36e-6 * pi, 1e-12);
    EXPECT_EQ(laid.covered_by[static_cast<std::size_t>(f)].size(), 2U);  // the base, and a top
    EXPECT_NEAR(laid.sheet.outward_normal(FaceId(f), laid.sheet.domain(FaceId(f)).low).z(), 1, 1e-12);
  }
  for (const auto vertex : laid.sheet.vertices().colwise()) EXPECT_NEAR(vertex.z(), 0.5, 1e-12);
}

TEST(Overlay, DrawsEdgesInOtherSizes) {
  const Brep solid = test::made_brep("drilled");
  Redrawn redrawn;
  for (int e = 0; e < static_cast<int>(solid.edges().size()); ++e)
    if (solid.edge(EdgeId(e)).kind == CurveKind::circle) redrawn[EdgeId(e)] = Scaled{{0.015, 0.01, 0}, 0.5};
  const Overlay laid = overlay(solid, floors(solid), {0, 0, 0}, {0, 0, 1}, redrawn);
  ASSERT_EQ(laid.sheet.faces().size(), 1U);
  EXPECT_NEAR(laid.sheet.area(FaceId(0)), 600e-6 - 6.25e-6 * 3.14159265358979323846, 1e-12);
}

// The floor of a flat ends at a cylinder whose seam comes up to the middle of its arc.
TEST(Overlay, DrawsArcsThatASeamDividesAsOne) {
  const Brep solid = test::made_brep("flatted_pin");
  int divided = 0;
  for (const FaceId face : floors(solid)) {
    const Overlay laid = overlay(solid, {face}, {0, 0, 0}, {0, 0, 1});
    divided += solid.face(face).loops.front().size() > 2 ? 1 : 0;
    if (solid.face(face).loops.front().size() == 3) {
      EXPECT_EQ(laid.sheet.edges().size(), 2U);
    }
    EXPECT_NEAR(laid.sheet.area(FaceId(0)), solid.area(face), 1e-12);
  }
  EXPECT_GE(divided, 1);
}

TEST(Overlay, DrawsLinesToo) {
  // The block's top and bottom, with a line across and one that ends inside.
  const Brep solid = test::made_brep("block");
  const Overlay laid = overlay(solid, floors(solid), {0, 0, 0}, {0, 0, 1}, {},
                               {{Eigen::Vector3d(0.01, 0, 0), Eigen::Vector3d(0.01, 0.02, 0)},
                                {Eigen::Vector3d(0.02, 0, 0), Eigen::Vector3d(0.02, 0.005, 0)}});
  ASSERT_EQ(laid.sheet.faces().size(), 2U);
  EXPECT_NEAR(laid.sheet.area(FaceId(0)) * laid.sheet.area(FaceId(1)), 200e-6 * 400e-6, 1e-16);
  for (const auto& floors_over : laid.covered_by) EXPECT_EQ(floors_over.size(), 2U);
}

}  // namespace
}  // namespace isopatch::geometry
