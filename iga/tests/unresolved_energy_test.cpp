#include "iga/problem/unresolved_energy.hpp"

#include <gtest/gtest.h>

#include "geometry/models/cylinder.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using testing::boundary;
using testing::problem;

ElasticityResults thick_cylinder(double nu, int degree, int refine) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::cylinder_model({.inner_radius = 3, .outer_radius = 9}));
  ElasticityProblem p =
      problem(model, {.degree = {degree, degree, degree}, .refine = refine}, isotropic(1000, nu));
  for (const char* plane : {"start", "end", "bottom", "top"})
    p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
  p.surface_loads = {pressure_load("pressure", boundary(model, "inner"), 1)};
  return solve_elasticity(p).results;
}

double share(const ElasticityResults& results) {
  return results.unresolved.total() / results.internal_energy;
}

TEST(UnresolvedEnergy, IsThatOfVolumeChangesWhereElementsLock) {
  const ElasticityResults locked = thick_cylinder(0.499, 2, 2);
  EXPECT_GT(share(locked), 0.02);
  EXPECT_GT(locked.unresolved.volumetric, 0.5 * locked.unresolved.total());
  EXPECT_LT(share(thick_cylinder(0.499, 4, 2)), 0.02);
  EXPECT_LT(share(thick_cylinder(0.3, 2, 2)), 0.02);
}

// A beam of one element in its height under a bending moment: stress = z.
double bending_share(int degree) {
  const geometry::MultiPatch model = geometry::connect(geometry::box_model({.size = {4, 1, 1}}));
  ElasticityProblem p = problem(
      model, {.degree = {degree, degree, degree}, .elements_per_direction = {4, 1, 1}}, isotropic(1e9, 0));
  p.supports = {
      {"plane", boundary(model, "x_min"), PlaneSupport{}},
      {"side", boundary(model, "y_min"), PlaneSupport{}},
      {"point", boundary(model, "x_min"), PrescribedDisplacement{{std::nullopt, std::nullopt, 0.0}}}};
  p.surface_loads = {
      {"moment", boundary(model, "x_max"), [](const Eigen::Vector3d& x, const Eigen::Vector3d&) {
         return Eigen::Vector3d(1e3 * (x[2] - 0.5), 0, 0);
       }}};
  return share(solve_elasticity(p).results);
}

TEST(UnresolvedEnergy, IsLargeWhereDegreeOneBends) {
  EXPECT_GT(bending_share(1), 0.2);
  EXPECT_LT(bending_share(2), 1e-3);
}

}  // namespace
}  // namespace isopatch::iga
