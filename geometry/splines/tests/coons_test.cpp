#include "geometry/splines/coons.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

// Two arcs, a line and a cubic.
std::array<NurbsCurve, 4> sides() {
  Eigen::Matrix3Xd cubic(3, 4);
  cubic << 0, -0.5, 0.5, 0,  //
      3, 2, 1.5, 1,          //
      1, 2, 0.5, 0;
  return {arc({0, 0, 0}, 1, Angle::degrees(90), Angle::degrees(0)), segment({1, 0, 0}, {3, 0, 1}),
          arc({0, 0, 1}, 3, Angle::degrees(0), Angle::degrees(90)),
          NurbsCurve({KnotVector::bezier(3)}, cubic)};
}

TEST(CoonsSurface, IsExactOnAllFourSides) {
  const auto given = sides();
  const NurbsSurface surface = coons_surface(given);
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const std::array<Parameter<2>, 4> at{Parameter<2>(t, 0), Parameter<2>(1, t), Parameter<2>(1 - t, 1),
                                         Parameter<2>(0, 1 - t)};
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_LT((surface.point(at[k]) - given[k].point(Parameter<1>(t))).norm(), 1e-14) << k << " at " << t;
  }
}

TEST(CoonsSurface, BetweenStraightSidesIsTheBilinearOne) {
  const std::array<NurbsCurve, 4> square{segment({0, 0, 0}, {2, 0, 0}), segment({2, 0, 0}, {2, 1, 1}),
                                         segment({2, 1, 1}, {0, 1, 0}), segment({0, 1, 0}, {0, 0, 0})};
  EXPECT_LT((coons_surface(square).point({0.5, 0.5}) - Eigen::Vector3d(1, 0.5, 0.25)).norm(), 1e-15);
}

TEST(CoonsSurface, NeedsSidesThatMeet) {
  auto apart = sides();
  std::swap(apart[1], apart[2]);
  EXPECT_ERROR(coons_surface(apart), ErrorCode::invalid_argument, "do not meet");
}

}  // namespace
}  // namespace isopatch::geometry
