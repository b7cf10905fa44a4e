// Cuts and symmetry that the user gives.

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/decomposition/decompose.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::test::made_brep;

Decomposition cut(const Brep& solid, const std::vector<GivenPlane>& cuts) {
  DecompositionOptions options;
  options.cuts = cuts;
  return decompose(solid, "part", options);
}

GivenPlane across(const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
  GivenPlane result;
  result.normal = normal;
  result.point = point;
  return result;
}

TEST(ByHand, CutsDivideASolidAsAsked) {
  // A block of 30 x 20 x 10 in three.
  const Decomposition made =
      cut(made_brep("block"), {across({1, 0, 0}, {0.01, 0, 0}), across({3, 0, 0}, {0.02, 0, 0})});
  EXPECT_EQ(made.complex.cells.size(), 3U);
  EXPECT_EQ(made.report.seen_as.substr(0, 22), "3 pieces: swept along ");
}

TEST(ByHand, WithoutAPointThePlaneIsInTheMiddle) {
  GivenPlane middle;
  middle.normal = Eigen::Vector3d(0, 0, 1);
  EXPECT_EQ(cut(made_brep("drilled"), {middle}).complex.cells.size(), 8U);
}

TEST(ByHand, FacesAreExtendedAndPlanesGoThroughPoints) {
  // The top of the plate, below the boss; it is face 3 or another.
  const Brep boss = made_brep("bored_boss");
  int top = -1;
  for (int f = 0; f < static_cast<int>(boss.faces().size()); ++f)
    if (const auto carrier = boss.carrier(FaceId(f)); carrier->kind == geometry::SurfaceKind::plane &&
                                                      std::abs(carrier->axis.z()) > 0.5 &&
                                                      std::abs(carrier->origin.z() - 0.01) < 1e-9)
      top = f;
  ASSERT_GE(top, 0);
  GivenPlane extended;
  extended.face = "face " + std::to_string(top);
  EXPECT_NEAR(plane_of(boss, extended).origin.z(), 0.01, 1e-12);
  GivenPlane through;
  through.through = {{0, 0, 0.01}, {0.01, 0, 0.01}, {0, 0.01, 0.01}, {0.02, 0.01, 0.01}};
  EXPECT_NEAR(std::abs(plane_of(boss, through).normal().z()), 1, 1e-12);
}

TEST(ByHand, SymmetryIsKept) {
  DecompositionOptions options;
  options.symmetry.emplace();
  options.symmetry->normal = Eigen::Vector3d(0, 1, 0);
  const Decomposition made = decompose(made_brep("angle"), "part", options);
  EXPECT_EQ(made.complex.cells.size() % 2, 0U);
  EXPECT_EQ(made.report.seen_as.substr(0, 18), "one half mirrored,");
}

TEST(ByHand, WhatCannotBeIsSaid) {
  const auto refused = [](const GivenPlane& plane, const char* text) {
    EXPECT_ERROR(cut(made_brep("drilled"), {plane}), ErrorCode::invalid_argument, text);
  };
  refused({}, "one of normal, face and through");
  refused(across({1, 0, 0}, {1, 0, 0}), "cut 1 cuts nothing off");
  GivenPlane plane;
  plane.face = "lid";
  refused(plane, "solid 'part': there is no face 'lid'");
  plane.face = "";
  plane.through = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  refused(plane, "on a line");
  plane.through = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  refused(plane, "lie in no plane");
  EXPECT_ERROR(cut(made_brep("spring"), {across({1, 0, 0}, {0, 0, 0})}), ErrorCode::unsupported,
               "the cuts given come to no pieces that can be swept");
}

}  // namespace
}  // namespace isopatch::segmentation
