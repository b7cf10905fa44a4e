#include "geometry/brep/overlay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/brep/solid_on_carriers.hpp"
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

/// A plate of height 1 over a square of side 2 and half a disc beside it, whose arc ends beside the square's
/// lines.
Brep plate_with_round_end(double gap) {
  const auto corner = [](int i) {  // of the square, as seen from above
    return Eigen::Vector3d(i == 0 || i == 3 ? -2 : 0, i < 2 ? -1 : 1, 0);
  };
  const Eigen::Vector3d up(0, 0, 1);
  CarrierSolid solid;
  solid.vertices.resize(3, 8);
  const auto straight = [&](int from, int to) {
    Eigen::Matrix3Xd points(3, CarrierSolid::points_of_edge);
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      points.col(i) =
          solid.vertices.col(from) + double(i) / 32 * (solid.vertices.col(to) - solid.vertices.col(from));
    return CarrierSolid::Edge{VertexId(from), VertexId(to), points, {}};
  };
  for (int i = 0; i < 8; ++i) solid.vertices.col(i) = corner(i % 4) + (i < 4 ? 0 : 1) * up;
  for (const int level : {0, 4})
    for (int i = 0; i < 4; ++i) {
      solid.edges.push_back(straight(level + i, level + (i + 1) % 4));
      if (i != 1) continue;
      for (int k = 1; k < 32; ++k) {
        const double turn = std::numbers::pi * (k / 32.0 - 0.5);
        solid.edges.back().points.col(k) << (1 + gap) * std::cos(turn), (1 + gap) * std::sin(turn), level / 4;
      }
    }
  for (int i = 0; i < 4; ++i) solid.edges.push_back(straight(i, i + 4));
  const auto plane = [](const Eigen::Vector3d& origin, const Eigen::Vector3d& normal) {
    return Carrier{SurfaceKind::plane, origin, normal, 0, 0, {}};
  };
  const auto use = [](int edge, bool reversed) { return EdgeUse{EdgeId(edge), reversed}; };
  solid.faces.push_back({"bottom",
                         plane({0, 0, 0}, -up),
                         false,
                         {{use(3, true), use(2, true), use(1, true), use(0, true)}},
                         {}});
  solid.faces.push_back(
      {"top", plane(up, up), false, {{use(4, false), use(5, false), use(6, false), use(7, false)}}, {}});
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d along = corner((i + 1) % 4) - corner(i);
    const Carrier carrier = i == 1 ? Carrier{SurfaceKind::cylinder, {0, 0, 0}, up, 1 + gap, 0, {}}
                                   : plane(corner(i), along.cross(up).normalized());
    solid.faces.push_back({"wall",
                           carrier,
                           false,
                           {{use(i, false), use(8 + (i + 1) % 4, false), use(4 + i, true), use(8 + i, true)}},
                           {}});
  }
  return make_brep(solid, 2 * gap);
}

TEST(Overlay, JoinsEdgesThatTouchWithinTheToleranceOfTheirCorner) {
  // The circle through an arc ends a tenth of that beside its corner: 6e-7 of the size.
  const double gap = 2e-5;
  const Brep solid = plate_with_round_end(gap);
  const Overlay laid = overlay(solid, floors(solid), {0, 0, 0}, {0, 0, 1});
  ASSERT_EQ(laid.sheet.faces().size(), 1U);
  EXPECT_EQ(laid.covered_by.front().size(), 2U);
  EXPECT_NEAR(laid.sheet.area(FaceId(0)), 4 + std::numbers::pi / 2, 10 * gap);
}

}  // namespace
}  // namespace isopatch::geometry
