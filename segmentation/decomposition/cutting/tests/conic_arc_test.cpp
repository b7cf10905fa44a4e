// Planes cut cylinders, cones, spheres and tori along exact arcs.

#include "segmentation/decomposition/cutting/conic_arc.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <variant>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/decomposition/cutting/tests/across_cell.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::CellId;
using geometry::NurbsCurve;
using geometry::Parameter;
using geometry::PlaneSurface;
using geometry::SurfaceKind;

PlaneSurface plane_at(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d n = normal.normalized(), x = n.unitOrthogonal();
  return {origin, x, n.cross(x)};
}

constexpr double degree = std::numbers::pi / 180;

/// A point of a surface about the z axis where a plane cuts the line from `foot` along `way`.
Eigen::Vector3d on_line(const PlaneSurface& plane, const Eigen::Vector3d& foot, const Eigen::Vector3d& way) {
  return foot + way * (plane.normal().dot(plane.origin - foot) / plane.normal().dot(way));
}

template <class Distance>
void expect_on(const NurbsCurve& arc, const PlaneSurface& plane, const Distance& distance) {
  for (int i = 0; i <= 40; ++i) {
    const Eigen::Vector3d p = arc.point(Parameter<1>(i / 40.0));
    EXPECT_NEAR(plane.normal().dot(p - plane.origin), 0, 1e-14) << i;
    EXPECT_NEAR(distance(p), 0, 1e-14) << i;
  }
}

TEST(ConicArc, OnACylinderGoesWithTheCirclesAngle) {
  const Carrier cylinder{SurfaceKind::cylinder, {0, 0, 0}, {0, 0, 1}, 2};
  const PlaneSurface plane = plane_at({0, 0, 3}, {0.4, -0.7, 1});
  const auto at = [&](double degrees) {
    return on_line(plane, {2 * std::cos(degrees * degree), 2 * std::sin(degrees * degree), 0}, {0, 0, 1});
  };
  const auto arc = conic_arc(cylinder, plane, at(170), at(200), at(260));
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->size(), 3);
  EXPECT_NEAR(arc->weights()[1], std::cos(45 * degree), 1e-14);
  expect_on(*arc, plane, [](const Eigen::Vector3d& p) { return p.head<2>().norm() - 2; });
  // As far around as the circle between the same rulings.
  const auto circle = conic_arc(cylinder, plane_at({0, 0, 0}, {0, 0, 1}),
                                {2 * std::cos(170 * degree), 2 * std::sin(170 * degree), 0}, at(200),
                                {2 * std::cos(260 * degree), 2 * std::sin(260 * degree), 0});
  ASSERT_TRUE(circle);
  for (const double t : {0.1, 0.4, 0.8})
    EXPECT_LT((arc->point(Parameter<1>(t)) - circle->point(Parameter<1>(t))).head<2>().norm(), 1e-14);
  // The other way around, in two pieces.
  const auto long_way = conic_arc(cylinder, plane, at(170), at(0), at(260));
  ASSERT_TRUE(long_way);
  EXPECT_EQ(long_way->size(), 7);
  EXPECT_LT((long_way->point(Parameter<1>(1)) - at(260)).norm(), 1e-14);
  expect_on(*long_way, plane, [](const Eigen::Vector3d& p) { return p.head<2>().norm() - 2; });
}

TEST(ConicArc, OnAConeIsAnEllipseAParabolaOrAHyperbola) {
  const Carrier cone{SurfaceKind::cone, {0, 0, 1}, {0, 0, 1}, 1, 0, Angle::degrees(45)};  // apex at 0
  for (const double slope : {0.3, 1.0, 1.6}) {
    const PlaneSurface plane = plane_at({0, 0, 2}, {slope, 0.1, 1});
    const auto at = [&](double degrees) {
      return on_line(plane, {0, 0, 0}, {std::cos(degrees * degree), std::sin(degrees * degree), 1});
    };
    const auto arc = conic_arc(cone, plane, at(-30), at(20), at(65));
    ASSERT_TRUE(arc) << slope;
    EXPECT_EQ(arc->weights()[0], 1);
    EXPECT_EQ(arc->weights()[2], 1);
    EXPECT_LT((arc->point(Parameter<1>(1)) - at(65)).norm(), 1e-14);
    expect_on(*arc, plane, [](const Eigen::Vector3d& p) { return p.head<2>().norm() - p.z(); });
  }
}

TEST(ConicArc, OnASphereAndATorusIsACircle) {
  const Carrier sphere{SurfaceKind::sphere, {0, 0, 0}, {0, 0, 1}, 5};
  const PlaneSurface across = plane_at({1, 2, 2}, {1, 2, 2});  // radius 4
  const auto at = [&](double degrees) -> Eigen::Vector3d {
    return across.origin +
           4 * (std::cos(degrees * degree) * across.x + std::sin(degrees * degree) * across.y);
  };
  const auto arc = conic_arc(sphere, across, at(10), at(40), at(100));
  ASSERT_TRUE(arc);
  expect_on(*arc, across, [](const Eigen::Vector3d& p) { return p.norm() - 5; });
  const Carrier torus{SurfaceKind::torus, {0, 0, 0}, {0, 0, 1}, 5, 1};
  const auto on_tube = [](const Eigen::Vector3d& p) { return std::hypot(p.head<2>().norm() - 5, p.z()) - 1; };
  const PlaneSurface flat = plane_at({0, 0, 0.6}, {0, 0, 1});
  const auto parallel = conic_arc(torus, flat, {5.8, 0, 0.6}, {3, 4, 0.6}, {0, 5.8, 0.6});
  ASSERT_TRUE(parallel);
  expect_on(*parallel, flat, on_tube);
  const PlaneSurface upright = plane_at({0, 0, 0}, {0, 1, 0});
  const auto meridian = conic_arc(torus, upright, {6, 0, 0}, {5.6, 0, 0.8}, {5, 0, 1});
  ASSERT_TRUE(meridian);
  expect_on(*meridian, upright, on_tube);
}

TEST(ConicArc, IsNoneWhereTheSectionIsStraightOrNoConic) {
  const Carrier cylinder{SurfaceKind::cylinder, {0, 0, 0}, {0, 0, 1}, 2};
  EXPECT_FALSE(conic_arc(cylinder, plane_at({2, 0, 0}, {1, 0, 0}), {2, 0, 0}, {2, 0, 1}, {2, 0, 3}));
  const Carrier torus{SurfaceKind::torus, {0, 0, 0}, {0, 0, 1}, 5, 1};
  EXPECT_FALSE(conic_arc(torus, plane_at({5, 0, 0}, {1, 0, 1}), {5, 0.5, 0}, {5, 0, 0}, {5, -0.5, 0}));
}

/// A made solid cut by a plane: the volumes add up, and new edges on its curved faces are exact arcs.
void expect_exact_cut(const char* name, const PlaneSurface& plane, int arcs) {
  const geometry::Brep solid = geometry::test::made_brep(name);
  const CutAttempt attempt = samples::cut_across(solid, one_cell(solid), CellId(0), plane);
  ASSERT_TRUE(attempt.cut) << name << ": " << attempt.refusal;
  const geometry::CellComplex& complex = attempt.cut->complex;
  EXPECT_TRUE(std::holds_alternative<PlaneSurface>(complex.surface(complex.face(attempt.cut->face).surface)));
  int found = 0;
  for (const geometry::EdgeUse& use : complex.face(attempt.cut->face).loop)
    if (const auto& curve = std::get<NurbsCurve>(complex.curve(complex.edge(use.edge).curve).shape);
        curve.is_rational()) {
      ++found;
      EXPECT_EQ(curve.degree(0), 2);
      for (const double t : {0.2, 0.5, 0.9})
        EXPECT_NEAR(plane.normal().dot(curve.point(Parameter<1>(t)) - plane.origin), 0, 1e-16);
    }
  EXPECT_EQ(found, arcs) << name;
  double volume = 0;
  for (const geometry::Brep& part : cell_solids(solid, complex)) volume += part.volume();
  EXPECT_NEAR(volume, solid.volume(), 1e-11 * solid.volume()) << name;
}

TEST(CutCell, LeavesExactArcsOnCurvedSides) {
  expect_exact_cut("ring_quarter", plane_at({0, 0, 0.0015}, {-0.1, -0.15, 1}), 2);
  expect_exact_cut("ring_150", plane_at({0, 0, 0.0020}, {-0.1, -0.1, 1}), 2);
  expect_exact_cut("cone_quarter", plane_at({0, 0, 0.0015}, {-0.2, -0.1, 1}), 2);
  expect_exact_cut("shell_piece", plane_at({0, 0, 0.002}, {-0.3, -0.2, 1}), 2);
}

}  // namespace
}  // namespace isopatch::segmentation
