// What splines promise exactly, to round-off: rounds are round, refining moves no point, bases sum to one,
// derivatives are derivatives.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/base/larger.hpp"
#include "geometry/models/elbow.hpp"
#include "geometry/models/sphere.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/basis.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/tests/random_nurbs.hpp"
#include "geometry/splines/transfer.hpp"
#include "iga/spaces/discretization.hpp"
#include "iga/spaces/element.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/model_cases.hpp"

namespace isopatch::verification {
namespace {

using namespace geometry;
using geometry::test::random_knots;
using geometry::test::random_nurbs;
using geometry::test::random_parameter;

const Tolerance of_a_sum = round_off(3, "a sum of some ten terms of size 1");
const Tolerance of_a_chain =
    round_off(200, "sums one after the other, as in knot insertion, degree elevation, the quotient rule");
// Steps of 1e-3: 1e-12 times the ratio of fifth to first derivatives, and 1e-16 / 1e-3.
const Tolerance of_differences = {1e-8,
                                  "differences of fourth order, worst where fifth derivatives are large"};

// `value` is an error relative to what it is an error of, so that 0 is expected of it.
void expect_none(const std::string& what, const std::string& source, double value, const Tolerance& allowed) {
  expect(Claim{what, "", ReferenceKind::exact, source, 0, value, allowed, {}});
}

template <int D>
double size_of(const Nurbs<D>& spline) {
  return spline.control_points().cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
}

// Largest error of `residual` over random parameters of the faces of a named boundary.
template <class Residual>
double worst_on(const MultiPatch& model, const std::string& boundary, const Residual& residual) {
  std::mt19937 random(1);
  double worst = -1;
  for (const Boundary& b : model.boundaries()) {
    if (b.name != boundary) continue;
    for (const PatchFace& face : b.faces) {
      const NurbsSurface surface = face_surface(model.patch(face.patch), face.side);
      for (int i = 0; i < 100; ++i)
        worst = larger(worst, std::abs(residual(surface, random_parameter(random, surface))));
    }
  }
  return worst < 0 ? std::nan("") : worst;
}

TEST(SplineExactness, Circles) {
  std::mt19937 random(2);
  for (const double degrees : {30.0, 90.0, 120.0, 170.0}) {
    const NurbsCurve one = arc({0, 0, 0}, 2, Angle::degrees(10), Angle::degrees(10 + degrees));
    const NurbsCurve finer = insert_knots(elevate_degree(one, 0, 3), 0, {0.2, 0.2, 0.7});
    double radius = 0, speed = 0, bend = 0, moved = 0;
    for (int i = 0; i < 100; ++i) {
      const Parameter<1> t = random_parameter(random, one);
      const Eigen::Vector3d x = one.point(t), v = one.derivative(t, {1}), a = one.derivative(t, {2});
      radius = larger(radius, std::abs(x.norm() / 2 - 1));
      speed = larger(speed, std::abs(x.dot(v)) / (2 * v.norm()));
      bend = larger(bend, std::abs(x.dot(a) + v.squaredNorm()) / v.squaredNorm());
      moved = larger(moved, (finer.point(t) - x).norm() / 2);
    }
    const std::string of = fmt::format("NURBS arc of {} degrees", degrees);
    expect_none(of + ": distance of its points from the circle", "|x| = r", radius, of_a_sum);
    expect_none(of + ": first derivative along the radius", "x.x' = 0", speed, of_a_sum);
    expect_none(of + ": second derivative along the radius", "x.x'' = -x'.x'", bend, of_a_chain);
    expect_none(of + ": refined by degree and knots, movement of its points", "the same curve", moved,
                of_a_sum);
  }
}

TEST(SplineExactness, Spheres) {
  const MultiPatch sphere = connect(sphere_model({.inner_radius = 1, .outer_radius = 3}));
  for (const auto& [name, radius] : {std::pair{"inner", 1.0}, std::pair{"outer", 3.0}}) {
    const std::string of = fmt::format("hollow sphere, {} surface", name);
    expect_none(of + ": distance of its points from the sphere", "|x| = r",
                worst_on(sphere, name,
                         [r = radius](const NurbsSurface& s, const Parameter<2>& t) {
                           return s.point(t).norm() / r - 1;
                         }),
                of_a_sum);
    expect_none(of + ": tangents along the radius", "x.x_u = 0",
                worst_on(sphere, name,
                         [](const NurbsSurface& s, const Parameter<2>& t) {
                           return (s.jacobian(t).colwise().normalized().transpose() * s.point(t).normalized())
                               .cwiseAbs()
                               .maxCoeff<Eigen::PropagateNaN>();
                         }),
                of_a_sum);
    expect_none(of + ": mixed second derivative along the radius", "x.x_uv = -x_u.x_v",
                worst_on(sphere, name,
                         [&](const NurbsSurface& s, const Parameter<2>& t) {
                           const auto j = s.jacobian(t);
                           return (s.point(t).dot(s.derivative(t, {1, 1})) + j.col(0).dot(j.col(1))) /
                                  (j.col(0).norm() * j.col(1).norm());
                         }),
                of_a_chain);
  }
}

TEST(SplineExactness, Pipes) {
  // The defaults: a tube of radii 8 and 10 up the z axis to z = 15, bent about the line x = 20, z = 15.
  const MultiPatch elbow = connect(elbow_model());
  for (const auto& [name, radius] : {std::pair{"inner", 8.0}, std::pair{"outer", 10.0}})
    expect_none(fmt::format("pipe elbow, {} surface: distance of its points from cylinder and torus", name),
                "distance from the axis = r",
                worst_on(elbow, name,
                         [r = radius](const NurbsSurface& s, const Parameter<2>& t) {
                           const Eigen::Vector3d x = s.point(t);
                           const Eigen::Vector2d from_centre(x[0] - 20, x[2] - 15);
                           double off_axis = x[0];  // in the plane of the bend
                           if (x[2] > 15) off_axis = from_centre.norm() - 20;
                           if (x[0] > 20) off_axis = x[2] - 35;
                           return std::hypot(off_axis, x[1]) / r - 1;
                         }),
                of_a_sum);
}

// Random knots into every direction, each degree raised by 0 .. 2.
NurbsVolume randomly_refined(const NurbsVolume& patch, std::mt19937& random) {
  NurbsVolume result = patch;
  std::uniform_int_distribution<int> count(0, 2);
  for (int d = 0; d < 3; ++d) {
    result = elevate_degree(result, d, count(random));
    std::vector<double> knots;
    for (int i = count(random); i >= 0; --i) knots.push_back(random_parameter(random, patch)[d]);
    std::sort(knots.begin(), knots.end());
    result = insert_knots(result, d, knots);
  }
  return result;
}

TEST(SplineExactness, Refinement) {
  for (const ModelCase& c : every_model_case()) {
    std::mt19937 random(3);
    double moved = 0, turned = 0;
    for (const NurbsVolume& patch : patches_of(c).patches) {
      const NurbsVolume fine = randomly_refined(patch, random);
      for (int i = 0; i < 20; ++i) {
        const Parameter<3> t = random_parameter(random, patch);
        moved = larger(moved, (fine.point(t) - patch.point(t)).norm() / size_of(patch));
        turned = larger(turned, (fine.jacobian(t) - patch.jacobian(t)).norm() / patch.jacobian(t).norm());
      }
    }
    const std::string of = c.name + ", knots inserted and degrees raised at random: ";
    expect_none(of + "movement of points", "the same map", moved, of_a_sum);
    expect_none(of + "change of the Jacobian matrix", "the same map", turned, of_a_chain);
  }
}

TEST(SplineExactness, BezierExtraction) {
  for (const bool rational : {false, true}) {
    std::mt19937 random(4);
    double moved = 0, apart = 0;
    for (int trial = 0; trial < 20; ++trial) {
      const NurbsVolume spline = random_nurbs<3>(random, 4, rational);
      const std::vector<NurbsVolume> pieces = bezier_pieces(spline);
      for (const NurbsVolume& piece : pieces)
        for (int i = 0; i < 5; ++i) {
          const Parameter<3> t = random_parameter(random, piece);
          moved = larger(moved, (geometry::test::de_casteljau(piece, t) - spline.point(t)).norm());
        }
      // In one space again, pieces and spline have the same coefficients.
      NurbsVolume::KnotVectors knots;
      for (int d = 0; d < 3; ++d) knots[static_cast<std::size_t>(d)] = bezier_knots(spline.knots(d));
      const NurbsVolume whole = refined(spline, knots);
      apart = larger(
          apart,
          (pieces.front().control_points().col(0) - whole.control_points().col(0)).norm() +
              (pieces.back().control_points().rightCols(1) - whole.control_points().rightCols(1)).norm());
    }
    const std::string of = rational ? "random NURBS volumes" : "random B-spline volumes";
    expect_none(of + ": Bezier pieces by de Casteljau's algorithm against the spline", "the same map", moved,
                of_a_chain);
    expect_none(of + ": corner coefficients of Bezier pieces and of Bezier knots", "the same map", apart,
                of_a_chain);
  }
}

// A basis function by its recursive definition: the plain reference.
double cox_de_boor(const std::vector<double>& u, int i, int p, double t) {
  const auto k = static_cast<std::size_t>(i);
  const auto q = static_cast<std::size_t>(p);
  if (p == 0) return u[k] <= t && t < u[k + 1] ? 1 : 0;
  double sum = 0;
  if (u[k + q] > u[k]) sum += (t - u[k]) / (u[k + q] - u[k]) * cox_de_boor(u, i, p - 1, t);
  if (u[k + q + 1] > u[k + 1])
    sum += (u[k + q + 1] - t) / (u[k + q + 1] - u[k + 1]) * cox_de_boor(u, i + 1, p - 1, t);
  return sum;
}

// Errors of the B-splines of one degree at random parameters of random knots.
struct BasisErrors {
  double sum = 0, sums_of_derivatives = 0, negative = 0, recursion = 0, identity = 0, slope = 0;
};

BasisErrors basis_errors(int degree) {
  std::mt19937 random(5);
  BasisErrors worst;
  const auto grow = [](double& largest, double value) { largest = larger(largest, std::abs(value)); };
  for (int trial = 0; trial < 50; ++trial) {
    const KnotVector knots = random_knots(random, degree);
    std::uniform_real_distribution<double> inside(knots.first(), knots.last());
    const std::vector<double> greville = knots.greville();
    for (int i = 0; i < 20; ++i) {
      const double t = inside(random);
      const BasisValues b = basis(knots, t, 1);
      grow(worst.sum, b.values.row(0).sum() - 1);
      grow(worst.sums_of_derivatives, b.values.row(1).sum() / b.values.row(1).cwiseAbs().sum());
      grow(worst.negative, std::min(0.0, b.values.row(0).minCoeff<Eigen::PropagateNaN>()));
      double place = 0, slope = 0;
      for (int a = 0; a <= degree; ++a) {
        grow(worst.recursion, b.values(0, a) - cox_de_boor(knots.knots(), b.first + a, degree, t));
        place += b.values(0, a) * greville[static_cast<std::size_t>(b.first + a)];
        slope += b.values(1, a) * greville[static_cast<std::size_t>(b.first + a)];
      }
      grow(worst.identity, (place - t) / knots.length());
      grow(worst.slope, slope - 1);
    }
  }
  return worst;
}

TEST(SplineExactness, Bases) {
  for (const int degree : {1, 2, 3, 5, 8}) {
    const BasisErrors e = basis_errors(degree);
    const std::string of = fmt::format("B-splines of degree {} on random knots: ", degree);
    expect_none(of + "sum of the functions, less 1", "partition of unity", e.sum, of_a_sum);
    expect_none(of + "sum of the derivatives", "partition of unity", e.sums_of_derivatives, of_a_sum);
    expect_none(of + "most negative value", "positivity", e.negative, 0);
    expect_none(of + "difference from the recursion", "Cox, de Boor", e.recursion, of_a_sum);
    expect_none(of + "the identity from Greville abscissae", "linear precision", e.identity, of_a_sum);
    expect_none(of + "its derivative, less 1", "linear precision", e.slope, of_a_chain);
  }
}

// Derivatives of a random spline against central differences of the next lower ones, relative.
template <int D>
double difference_error(bool rational) {
  std::mt19937 random(6);
  double worst = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const Nurbs<D> spline = random_nurbs<D>(random, 4, rational);
    const Nurbs<D> inside = bezier_pieces(spline)[0];  // differences must not step over a knot
    const Parameter<D> t = 0.5 * (inside.low() + inside.high());
    for (int d = 0; d < D; ++d)
      for (int e = 0; e < D; ++e) {
        std::array<int, D> once{}, twice{};
        once[static_cast<std::size_t>(e)] = twice[static_cast<std::size_t>(e)] = 1;
        ++twice[static_cast<std::size_t>(d)];
        // Fourth order: (8 (f(h) - f(-h)) - (f(2h) - f(-2h))) / 12 h.
        const double h = 1e-3 * inside.knots(d).length();
        const auto f = [&](double steps) {
          return spline.derivative(t + steps * h * Parameter<D>::Unit(d), once);
        };
        const Eigen::Vector3d difference = (8 * (f(1) - f(-1)) - (f(2) - f(-2))) / (12 * h);
        const double size = f(0).norm() / inside.knots(d).length();
        worst = larger(worst, (spline.derivative(t, twice) - difference).norm() / size);
      }
  }
  return worst;
}

TEST(SplineExactness, Derivatives) {
  for (const bool rational : {false, true}) {
    const std::string of = rational ? "random NURBS " : "random B-spline ";
    expect_none(of + "surfaces: second derivatives against differences", "differences of fourth order",
                difference_error<2>(rational), of_differences);
    expect_none(of + "volumes: second derivatives against differences", "differences of fourth order",
                difference_error<3>(rational), of_differences);
  }
}

// Functions of the solution space in space: sum N = 1, sum grad N = 0, sum x grad N = I.
TEST(SplineExactness, SolutionSpaces) {
  for (const ModelCase& c : every_model_case()) {
    const iga::Discretization d = iga::discretize(connect(patches_of(c)), {.degree = {3, 3, 3}, .refine = 1});
    double sum = 0, gradient = 0, identity = 0;
    iga::ElementValues values;
    for (const NurbsVolume& patch : d.patches) {
      const iga::ElementEvaluator evaluator(patch, 2);
      for (std::int64_t e = 0; e < evaluator.element_count(); ++e) {
        evaluator.evaluate(e, values);
        Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(values.functions.size()));
        for (Eigen::Index a = 0; a < points.cols(); ++a)
          points.col(a) = patch.control_points().col(values.functions[static_cast<std::size_t>(a)]);
        for (Eigen::Index q = 0; q < values.measures.size(); ++q) {
          sum = larger(sum, std::abs(values.values.col(q).sum() - 1));
          for (std::size_t j = 0; j < 3; ++j) {
            const Eigen::VectorXd g = values.gradients[j].col(q);
            gradient = larger(gradient, std::abs(g.sum()) / g.cwiseAbs().sum());
            identity =
                larger(identity, (points * g - Eigen::Vector3d::Unit(static_cast<Eigen::Index>(j))).norm());
          }
        }
      }
    }
    const std::string of = "solution space on the " + c.name + ": ";
    expect_none(of + "sum of the functions, less 1", "partition of unity", sum, of_a_sum);
    expect_none(of + "sum of the gradients", "partition of unity", gradient, of_a_chain);
    expect_none(of + "gradient of the place, less the unit matrix", "isoparametric", identity, of_a_chain);
  }
}

}  // namespace
}  // namespace isopatch::verification
