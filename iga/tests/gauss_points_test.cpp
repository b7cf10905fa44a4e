#include "iga/spaces/gauss_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/base/larger.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/splines/refine.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;
using geometry::NurbsVolume;
using testing::boundary;
using testing::problem;

const Material stiff_steel = isotropic(205e9, 0.29);

TEST(GaussPoints, AffineMapsKeepDegreePlusOne) {
  const NurbsVolume cube;
  Eigen::Matrix3d map;
  map << 2, 0.3, -0.5, 0.1, 0.4, 0.7, 0, -0.6, 3;
  const Eigen::Matrix3Xd points = (map * cube.control_points()).colwise() + Eigen::Vector3d(100, -70, 30);
  const geometry::MultiPatch model = geometry::connect({{NurbsVolume(cube.knots(), points)}, {}, {}});
  const Discretization d = discretize(model, {.degree = {2, 3, 4}, .refine = 2});
  EXPECT_EQ(d.gauss_points[0], (GaussPoints{3, 4, 5}));
}

TEST(GaussPoints, ArcsNeedMoreThanStraightDirectionsAndFewerWhenRefined) {
  const geometry::MultiPatch model = geometry::connect(geometry::cylinder_model());
  const GaussPoints coarse = discretize(model, {.degree = {2, 2, 2}}).gauss_points[0];
  const GaussPoints fine = discretize(model, {.degree = {2, 2, 2}, .refine = 4}).gauss_points[0];
  EXPECT_GT(coarse[1], 6);
  EXPECT_EQ(coarse[2], 3);
  EXPECT_LE(fine[1], 4);
  EXPECT_EQ(fine[0], 3);
}

// u = gradient x on the whole boundary: inside it is that only if the integrals are exact.
double patch_test_error(const geometry::MultiPatch& model, const DiscretizationOptions& options) {
  Eigen::Matrix3d gradient;
  gradient << 1e-3, 2e-4, -3e-4, 5e-4, -7e-4, 1e-4, 2e-4, 6e-4, 4e-4;
  ElasticityProblem p = problem(model, options, stiff_steel);
  p.supports = {{"boundary", model.boundary_faces(), PrescribedDisplacement{.gradient = gradient}}};
  const ElasticField field = solve_elasticity(p).field;
  double error = 0, size = 0;
  for (std::size_t i = 0; i < field.patches.size(); ++i) {
    const Eigen::Matrix3Xd exact = gradient * field.patches[i].control_points();
    error =
        isopatch::larger(error, (field.displacement[i] - exact).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
    size = isopatch::larger(size, exact.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
  return error / size;
}

TEST(GaussPoints, PatchTestsHoldOnCurvedModels) {
  const geometry::MultiPatch ring =
      geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(240), .radial_patches = 2}));
  const geometry::MultiPatch box = geometry::connect(geometry::box_model(
      {.patches = {2, 2, 2}, .distortion = 0.2, .curvature = 0.3, .orientation_seed = 3}));
  for (const int degree : {2, 3})
    for (const int refine : {0, 1}) {
      const DiscretizationOptions options{.degree = {degree, degree, degree}, .refine = refine};
      EXPECT_LT(patch_test_error(ring, options), 1e-9) << degree << " " << refine;
      EXPECT_LT(patch_test_error(box, options), 1e-9) << degree << " " << refine;
    }
}

// A quarter of a pipe about the x axis, cut at its end along x = -y: one rational element of degrees 3, 2, 1.
geometry::MultiPatch mitred_pipe() {
  const KnotVector along = KnotVector::bezier(3), around = KnotVector::bezier(2);
  const double half = std::sqrt(0.5);
  const double across[3][3] = {{0, 1, 1}, {1, 1, half}, {1, 0, 1}};  // y, z, weight
  Eigen::Matrix3Xd points(3, 24);
  Eigen::VectorXd weights(24);
  int at = 0;
  for (const double radius : {10.0, 9.0})
    for (const auto& [y, z, weight] : across)
      for (int i = 0; i < 4; ++i, ++at) {
        const double end = -radius * y;
        points.col(at) << -58 + (end + 58) * i / 3, radius * y, radius * z;
        weights[at] = weight;
      }
  return geometry::connect({{NurbsVolume({along, around, KnotVector()}, points, weights)}, {}, {}});
}

TEST(GaussPoints, EnergiesOfStronglyCurvedElementsAreThoseOfManyPoints) {
  const geometry::MultiPatch model = mitred_pipe();
  const auto energy = [&](const DiscretizationOptions& options, int points) {
    ElasticityProblem p = problem(model, options, stiff_steel);
    const auto face = [](geometry::Side side) {
      return std::vector<geometry::PatchFace>{{PatchId(0), side}};
    };
    p.supports = {{"held", face(geometry::Side::west), PrescribedDisplacement{}}};
    p.surface_loads = {constant_traction("pull", face(geometry::Side::east), {0, 1e6, 0})};
    return solve_elasticity(p, {.quadrature_points = points}).results.internal_energy;
  };
  for (const DiscretizationOptions& options :
       {DiscretizationOptions{}, DiscretizationOptions{.degree = {3, 3, 3}},
        DiscretizationOptions{.degree = {3, 3, 2}, .refine = 1}})
    EXPECT_NEAR(energy(options, 0) / energy(options, 20), 1, 1e-3);
  // Three points along the arc, its degree plus one, are not enough.
  EXPECT_GT(std::abs(energy({}, 3) / energy({}, 20) - 1), 0.01);
}

}  // namespace
}  // namespace isopatch::iga
