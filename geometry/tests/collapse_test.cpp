#include "geometry/collapse.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

using test::mapped;

const std::array<KnotVector, 3> knots = {KnotVector::bezier(2), KnotVector::bezier(3), KnotVector()};

// Points where `where` holds lose their coordinate along `direction`.
NurbsVolume collapsed_where(int direction, const std::function<bool(const Eigen::Vector3d&)>& where) {
  return mapped(knots, [&](const Eigen::Vector3d& t) {
    Eigen::Vector3d point = t;
    if (where(t)) point[direction] = 0;
    return point;
  });
}

int collapsed_edges(const NurbsVolume& volume) {
  const auto edges = all_edges();
  return static_cast<int>(std::count_if(edges.begin(), edges.end(),
                                        [&](const PatchEdge& e) { return is_collapsed(volume, e, 1e-12); }));
}

TEST(PatchFace, NumbersItsControlPointsLikeItsSurface) {
  const NurbsVolume volume =
      mapped(knots, [](const Eigen::Vector3d& t) { return Eigen::Vector3d(1 + t[0], 2 + t[1], t[2]); });
  for (const Side side : all_sides) {
    const NurbsSurface surface = face_surface(volume, side);
    const auto indices = face_control_points(volume.sizes(), side);
    ASSERT_EQ(surface.size(), static_cast<int>(indices.size()));
    for (int i = 0; i < surface.size(); ++i)
      EXPECT_EQ(surface.control_points().col(i),
                volume.control_points().col(indices[static_cast<std::size_t>(i)]));
    const Parameter<2> at(0.3, 0.8);
    EXPECT_LT((surface.point(at) - volume.point(on_side(volume, side, at))).norm(), 1e-15);
    EXPECT_EQ(on_side(volume, side, at)[direction(side)], is_high(side) ? 1 : 0);
    EXPECT_EQ(opposite(opposite(side)), side);
    EXPECT_EQ(side_of(direction(side), is_high(side)), side);
  }
}

TEST(Collapse, EdgesLieOnTheirSides) {
  const auto edges = all_edges();
  for (const PatchEdge& edge : edges) {
    int sides = 0;
    const auto points = edge_control_points({3, 4, 2}, edge);
    for (const Side side : all_sides) {
      const auto face = face_control_points({3, 4, 2}, side);
      sides += std::all_of(points.begin(), points.end(),
                           [&](int i) { return std::find(face.begin(), face.end(), i) != face.end(); });
    }
    EXPECT_EQ(sides, 2);
    EXPECT_EQ(std::count(edges.begin(), edges.end(), edge), 1);
  }
}

TEST(Collapse, NothingOfABoxIsCollapsed) {
  const NurbsVolume box = mapped(knots, [](const Eigen::Vector3d& t) { return t; });
  EXPECT_EQ(collapsed_edges(box), 0);
  for (const Side side : all_sides) EXPECT_FALSE(is_collapsed(box, side, 1e-12));
}

TEST(Collapse, FindsAnEdge) {
  const NurbsVolume wedge =
      collapsed_where(1, [](const Eigen::Vector3d& t) { return t[0] == 1 && t[2] == 0; });
  EXPECT_EQ(collapsed_edges(wedge), 1);
  EXPECT_TRUE(is_collapsed(wedge, PatchEdge{1, {true, false}}, 1e-12));
  for (const Side side : all_sides) EXPECT_FALSE(is_collapsed(wedge, side, 1e-12));
}

TEST(Collapse, FindsAFaceAndItsDirection) {
  const NurbsVolume wedge = collapsed_where(1, [](const Eigen::Vector3d& t) { return t[0] == 1; });
  EXPECT_EQ(collapsed_edges(wedge), 2);
  EXPECT_TRUE(is_collapsed(wedge, Side::east, 1e-12));
  EXPECT_TRUE(is_collapsed(wedge, Side::east, 1, 1e-12));
  EXPECT_FALSE(is_collapsed(wedge, Side::east, 2, 1e-12));
  EXPECT_FALSE(is_collapsed(wedge, Side::west, 1e-12));
  EXPECT_ERROR(is_collapsed(wedge, Side::east, 0, 1e-12), ErrorCode::invalid_argument,
               "direction 0 does not run in side");
}

TEST(Collapse, KnowsItsTolerance) {
  const NurbsVolume nearly = mapped(knots, [](const Eigen::Vector3d& t) {
    return Eigen::Vector3d(t[0], t[0] == 1 ? 1e-6 * t[1] : t[1], t[2]);
  });
  EXPECT_FALSE(is_collapsed(nearly, Side::east, 0.9e-6));
  EXPECT_TRUE(is_collapsed(nearly, Side::east, 1.1e-6));
}

}  // namespace
}  // namespace isopatch::geometry
