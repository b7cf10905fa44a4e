#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>

#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/check_brep.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/tests/step_text.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;
using std::numbers::pi;

/// Faces of a solid in a file's units.
using Faces = std::function<std::vector<int>(test::StepText&)>;

Brep solid_of(const Faces& faces, const std::string& unit = "m",
              const Eigen::Vector3d& offset = Eigen::Vector3d::Zero()) {
  const fs::path path =
      fs::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".step");
  test::StepText step(offset);
  const std::vector<int> made = faces(step);
  write_file(path, step.file(made, unit));
  const Brep brep = read_brep(path).brep;
  fs::remove(path);
  return brep;
}

void expect_measure(const Measure& found, double exact, double accuracy) {
  EXPECT_NEAR(found.value, exact, accuracy * exact);
  EXPECT_TRUE(found.converged()) << found.error << " of " << found.value;
  // The estimate is no less than the error, round-off aside.
  EXPECT_LE(std::abs(found.value - exact), found.error + accuracy * exact);
}

struct Exact {
  const char* name;
  Faces faces;
  double volume, area, length;
};

/// Perimeter of an ellipse by the arithmetic-geometric mean, to round-off.
/// @source Abramowitz, Stegun, Handbook of Mathematical Functions, 17.6
double perimeter(double a, double b) {
  double x = a, y = b, sum = 0, power = 0.5;
  sum = power * (a * a - b * b);
  while (std::abs(x - y) > 1e-15 * x) {
    const double difference = (x - y) / 2, mean = (x + y) / 2;
    y = std::sqrt(x * y);
    x = mean;
    power *= 2;
    sum += power * difference * difference;
  }
  return 2 * pi / x * (a * a - sum);
}

std::vector<Exact> known_solids() {
  const double slant = std::hypot(2, 3);
  return {
      {"block",
       [](auto& s) {
         return test::block(s, {1, 2, 3});
       },
       6, 22, 24},
      {"cylinder", [](auto& s) { return test::cylinder(s, 2, 5); }, 20 * pi, 28 * pi, 8 * pi + 5},
      {"cone", [](auto& s) { return test::cone(s, 2, 3); }, 4 * pi, 2 * pi * slant + 4 * pi, 4 * pi + slant},
      {"sphere", [](auto& s) { return test::sphere(s, 3); }, 36 * pi, 36 * pi, 3 * pi},
      {"torus", [](auto& s) { return test::torus(s, 5, 2); }, 40 * pi * pi, 40 * pi * pi, 18 * pi},
      {"ellipse of 20 x 2", [](auto& s) { return test::elliptic_prism(s, 10, 1, 3); }, 30 * pi,
       20 * pi + 3 * perimeter(10, 1), 2 * perimeter(10, 1) + 3},
  };
}

double length_of(const Brep& brep) {
  double sum = 0;
  for (const BrepEdge& edge : brep.edges()) sum += edge.length;
  return sum;
}

// 1e-10: an axis of a file has 17 digits and a thousand sizes take three of them.
TEST(Measure, SolidsOfClosedFormHaveTheirVolumeAreaAndLengthsAnywhereAndInEveryUnit) {
  for (const Exact& exact : known_solids())
    for (const auto& [unit, metres] : {std::pair("m", 1.0), std::pair("mm", 1e-3)})
      for (const double away : {0.0, 1000.0}) {
        SCOPED_TRACE(std::string(exact.name) + " in " + unit + (away > 0 ? ", far away" : ""));
        const Brep brep = solid_of(exact.faces, unit, away * 10 * Eigen::Vector3d(1, -0.7, 0.4));
        const double accuracy = away > 0 ? 1e-10 : 1e-12;
        expect_measure(brep.measured_volume(), std::pow(metres, 3) * exact.volume, accuracy);
        expect_measure(brep.measured_area(), std::pow(metres, 2) * exact.area, accuracy);
        EXPECT_NEAR(length_of(brep), metres * exact.length, 1e-10 * metres * exact.length);
      }
}

/// Enclosed area and length of a closed curve in the plane z = 0: Gauss rules of 64 points from knot to knot.
struct Outline {
  double area = 0, length = 0;
};
Outline outline(const NurbsCurve& curve) {
  const QuadratureRule rule = gauss_legendre(64);
  Outline result;
  const std::vector<double>& knots = curve.knots(0).knots();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (Eigen::Index k = 0; k < rule.nodes.size() && knots[i + 1] > knots[i]; ++k) {
      const double span = knots[i + 1] - knots[i];
      const Parameter<1> at(knots[i] + span * rule.nodes(k));
      const Eigen::Vector3d p = curve.point(at), d = curve.jacobian(at);
      result.area += span * rule.weights(k) * (p.x() * d.y() - p.y() * d.x()) / 2;
      result.length += span * rule.weights(k) * d.norm();
    }
  return result;
}

// 1e-9: the reference's own, where a curve nearly stops.
TEST(Measure, PrismsOverRandomClosedSplinesHaveTheirFigures) {
  for (unsigned seed = 0; seed < 12; ++seed)
    for (const double away : {0.0, 1000.0}) {
      SCOPED_TRACE(seed);
      const int degree = 2 + static_cast<int>(seed % 4), points = 5 + 2 * static_cast<int>(seed);
      const NurbsCurve curve = test::random_closed_spline(degree, points, seed);
      const double h = 0.1 + 0.3 * seed;
      const Outline exact = outline(curve);
      const Brep brep = solid_of([&](auto& step) { return test::spline_prism(step, curve, h); },
                                 seed % 2 ? "mm" : "m", away * 3 * Eigen::Vector3d(0.3, 1, -0.2));
      const double metres = seed % 2 ? 1e-3 : 1;
      expect_measure(brep.measured_volume(), std::pow(metres, 3) * exact.area * h, 1e-9);
      expect_measure(brep.measured_area(), std::pow(metres, 2) * (2 * exact.area + h * exact.length), 1e-9);
      EXPECT_NEAR(length_of(brep), metres * (2 * exact.length + h), 1e-9 * metres * exact.length);
      const BrepReport report = check(brep);
      EXPECT_TRUE(report.contradictions.empty()) << report.contradictions.front().text;
    }
}

// Its surface is one of revolution with two poles.
TEST(Measure, TurnedSplinesHaveTheVolumeOfPappus) {
  Eigen::Matrix3Xd points(3, 6);
  points << 0, 0.8, 1.2, 0.5, 0.9, 0,  //
      0, 0, 0, 0, 0, 0,                //
      0, 0.1, 0.8, 1.3, 2.2, 2.5;
  const NurbsCurve profile({KnotVector(3, {0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1})}, points);
  const QuadratureRule rule = gauss_legendre(64);
  double volume = 0, area = 0;
  for (const auto& [from, to] : {std::pair(0.0, 0.3), std::pair(0.3, 0.6), std::pair(0.6, 1.0)})
    for (Eigen::Index k = 0; k < rule.nodes.size(); ++k) {
      const Parameter<1> at(from + (to - from) * rule.nodes(k));
      const Eigen::Vector3d p = profile.point(at), d = profile.jacobian(at);
      volume += (to - from) * rule.weights(k) * pi * p.x() * p.x() * d.z();
      area += (to - from) * rule.weights(k) * 2 * pi * p.x() * d.norm();
    }
  const Brep brep = solid_of([&](auto& step) { return test::revolved(step, profile); });
  expect_measure(brep.measured_volume(), volume, 1e-11);
  expect_measure(brep.measured_area(), area, 1e-11);
}

TEST(Measure, ThinPlatesOfCurvedOutlineConvergeToo) {
  const NurbsCurve curve = test::random_closed_spline(3, 9, 7);
  const Outline exact = outline(curve);
  const double h = 1e-4;
  const Brep brep = solid_of([&](auto& step) { return test::spline_prism(step, curve, h); });
  expect_measure(brep.measured_volume(), exact.area * h, 1e-10);
}

TEST(Measure, AreasOfReversedFacesArePositive) {
  const Brep brep = make_brep(test::prism(5));
  Measure sum;
  for (std::size_t f = 0; f < brep.faces().size(); ++f) {
    const Measure area = brep.measured_area(FaceId(static_cast<int>(f)));
    EXPECT_GT(area.value, 0);
    sum.value += area.value;
  }
  EXPECT_NEAR(sum.value, test::polyhedron_area(test::prism(5)), 1e-13);
}

TEST(Measure, KnowsWhenItHasNotConverged) {
  EXPECT_TRUE((Measure{2, 1e-7}.converged()));
  EXPECT_TRUE((Measure{-2, 1e-7}.converged()));
  EXPECT_FALSE((Measure{2, 3e-7}.converged()));
  EXPECT_FALSE((Measure{2, INFINITY}.converged()));
  EXPECT_FALSE((Measure{2, NAN}.converged()));
}

}  // namespace
}  // namespace isopatch::geometry
