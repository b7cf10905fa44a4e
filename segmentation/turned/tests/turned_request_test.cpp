#include "segmentation/turned/turned_request.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/sweeps/tests/sound_cells.hpp"
#include "segmentation/turned/turned_cells.hpp"

namespace isopatch::segmentation {
namespace {

using Eigen::Vector3d;

/// A ring of radii 4 and 25 mm with a groove on each side, about the axis z.
geometry::Brep sheave() {
  return geometry::test::made_brep("sheave");
}

/// Places of a complex at a height and a radius, m.
std::vector<Vector3d> vertices_at(const geometry::CellComplex& complex, double radius, double height) {
  std::vector<Vector3d> result;
  for (const Vector3d& vertex : complex.vertices)
    if (std::abs(std::hypot(vertex.x(), vertex.y()) - radius) < 1e-9 && std::abs(vertex.z() - height) < 1e-9)
      result.push_back(vertex);
  return result;
}

TEST(TurnedRequest, PutsADirectionIntoTheMiddleOfASector) {
  const geometry::Brep solid = sheave();
  for (const int sectors : {3, 6}) {
    const Vector3d towards = Vector3d(0.6, 0.8, 0);
    const auto made = turned_cells(solid, TurnedRequest{.towards = towards, .sectors = sectors}, {});
    ASSERT_TRUE(made);
    EXPECT_EQ(made->sectors, sectors);
    test::expect_sound(solid, made->complex);
    const std::vector<Vector3d> around = vertices_at(made->complex, 4e-3, 0);
    ASSERT_EQ(static_cast<int>(around.size()), sectors);
    double nearest = std::numbers::pi;
    for (const Vector3d& vertex : around)
      nearest = smaller(nearest, std::acos(vertex.normalized().dot(towards)));
    EXPECT_NEAR(nearest, std::numbers::pi / sectors, 1e-9);
  }
}

TEST(TurnedRequest, DrawsRaysFromWhereTheyBeginToTheNextCurve) {
  const geometry::Brep solid = sheave();
  // Out of the bore, to the floor of the outer groove; then down from the middle of that ray to the floor of
  // the groove.
  const TurnedRequest request{.rays = {{Vector3d(4e-3, 0, 4.5e-3), Vector3d(1, 0, 0)},
                                       {Vector3d(0, 14e-3, 4.5e-3), Vector3d(0, 0, -1)}},
                              .towards = Vector3d(1, 0, 0),
                              .sectors = 4};
  const auto made = turned_cells(solid, request, {});
  ASSERT_TRUE(made);
  test::expect_sound(solid, made->complex);
  EXPECT_EQ(vertices_at(made->complex, 4e-3, 4.5e-3).size(), 4U);
  EXPECT_EQ(vertices_at(made->complex, 21e-3, 4.5e-3).size(), 4U);
  EXPECT_EQ(vertices_at(made->complex, 14e-3, 4.5e-3).size(), 4U);
  EXPECT_EQ(vertices_at(made->complex, 14e-3, 2e-3).size(), 4U);
}

TEST(TurnedRequest, SaysWhereARayHasNoCurve) {
  const auto cells = [](const Vector3d& from, const Vector3d& along) {
    return turned_cells(sheave(), TurnedRequest{.rays = {{from, along}}, .towards = Vector3d(1, 0, 0)}, {});
  };
  EXPECT_ERROR(cells({10e-3, 0, 4e-3}, {1, 0, 0}), ErrorCode::unsupported, "at (0.01, 0.004) m");
  EXPECT_ERROR(cells({25e-3, 0, 1e-3}, {1, 0, 0}), ErrorCode::unsupported, "beyond (0.025, 0.001) m");
}

TEST(TurnedRequest, IsForWholeTurnsAndQuartersWhereTheAxisIsReached) {
  const TurnedRequest thirds{.towards = Vector3d(1, 0, 0), .sectors = 3};
  EXPECT_FALSE(turned_cells(geometry::test::made_brep("half_shaft"), thirds, {}));
  EXPECT_FALSE(turned_cells(geometry::test::made_brep("block"), thirds, {}));
  EXPECT_ERROR(turned_cells(geometry::test::made_brep("shaft"), thirds, {}), ErrorCode::unsupported,
               "divided in quarters");
}

}  // namespace
}  // namespace isopatch::segmentation
