#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/cylinder.hpp"
#include "iga/problem/bearing_load.hpp"
#include "iga/problem/hydrostatic_load.hpp"
#include "iga/problem/loads.hpp"
#include "iga/problem/remote_load.hpp"
#include "iga/problem/rotation_load.hpp"
#include "iga/tests/load_resultant.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Vector3d;
using testing::boundary;
using testing::problem;
using testing::resultant;
using testing::Resultant;
using testing::steel;

ElasticityProblem sector(double degrees) {
  return problem(geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(degrees)})),
                 {.degree = {2, 2, 2}, .refine = 2}, steel);
}

TEST(BearingLoad, AddsUpToTheForceWithThePressureOfACosine) {
  ElasticityProblem p = sector(360);
  const Vector3d force(3, 4, 0);
  p.surface_loads = {bearing_load("pin", boundary(p.discretization.model, "inner"), force, p.discretization)};
  EXPECT_LT((resultant(p).force - force).norm(), 1e-12 * force.norm());
  // Radius 1, height 0.5: p = F / (R H pi / 2) where the force points. The elements where the pressure ends
  // see that at their Gauss points only, hence 1e-3.
  const auto pressure = [&](const Vector3d& direction) {
    return -p.surface_loads[0].traction(direction, -direction).dot(-direction);
  };
  const double most = 5 / (0.5 * std::numbers::pi / 2);
  EXPECT_NEAR(pressure({0.6, 0.8, 0}), most, 1e-3 * most);
  EXPECT_NEAR(pressure({0.8, -0.6, 0}), 0, 1e-3 * most);
  EXPECT_NEAR(pressure({1, 0, 0}), 0.6 * most, 1e-3 * most);
  EXPECT_EQ(pressure({-0.6, -0.8, 0}), 0);
}

TEST(BearingLoad, OnPartOfABoreTurnsUntilItAddsUp) {
  ElasticityProblem p = sector(120);  // from x towards -x, y
  const Vector3d force(1, 5, 0);      // not along the middle of the sector
  p.surface_loads = {bearing_load("pin", boundary(p.discretization.model, "inner"), force, p.discretization)};
  EXPECT_LT((resultant(p).force - force).norm(), 1e-12 * force.norm());
}

TEST(BearingLoad, RefusesWhatNoPressureCanCarry) {
  const ElasticityProblem p = sector(90);
  const auto inner = boundary(p.discretization.model, "inner");
  const auto load = [&](const Vector3d& force) { bearing_load("pin", inner, force, p.discretization); };
  EXPECT_ERROR(load({1, 1, 0.5}), ErrorCode::invalid_argument, "at right angles to its axis");
  EXPECT_ERROR(load({-1, -1, 0}), ErrorCode::invalid_argument, "no pressure on these faces");
  EXPECT_ERROR(load({0, 0, 0}), ErrorCode::invalid_argument, "not 0");
}

TEST(RemoteLoad, HasTheForceAndTheMomentOnCurvedFaces) {
  ElasticityProblem p = sector(90);
  const RemoteForce remote{{1, -2, 3}, {0.5, 0.25, -4}, Vector3d(10, -3, 7)};
  p.surface_loads = {remote_load("arm", boundary(p.discretization.model, "outer"), remote, p.discretization)};
  const Resultant found = resultant(p);
  const Vector3d moment = remote.moment + remote.point->cross(remote.force);
  EXPECT_LT((found.force - remote.force).norm(), 1e-12 * moment.norm());
  EXPECT_LT((found.moment - moment).norm(), 1e-12 * moment.norm());
}

TEST(RemoteLoad, WithoutAPointActsAtTheCentroidAndIsEven) {
  ElasticityProblem p = problem(testing::distorted_box(), {.degree = {2, 2, 2}}, steel);
  const auto top = boundary(p.discretization.model, "z_max");
  const SurfaceLoad load = remote_load("lift", top, {.force = {0, 0, 7}}, p.discretization);
  EXPECT_LT((load.traction({0.1, 0.9, 1}, Vector3d::UnitZ()) - Vector3d(0, 0, 7)).norm(), 1e-11);
}

TEST(RemoteLoad, RefusesAForceOfZero) {
  const ElasticityProblem p = sector(90);
  EXPECT_ERROR(remote_load("arm", boundary(p.discretization.model, "outer"), {}, p.discretization),
               ErrorCode::invalid_argument, "not 0");
}

TEST(HydrostaticLoad, LiftsWithTheWeightOfTheLiquidDisplaced) {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, steel);
  std::vector<geometry::PatchFace> all = model.boundary_faces();
  const Liquid water{1000, {0, 0, 3}, {0, 0, -10}};
  p.surface_loads = {hydrostatic_load("water", all, water, p.discretization)};
  const Resultant found = resultant(p);
  const Vector3d lift(0, 0, 1e4);
  const Vector3d moment = Vector3d(0.5, 0.5, 0.5).cross(lift);  // through the middle of what is displaced
  EXPECT_LT((found.force - lift).norm(), 1e-10 * lift.norm());  // pressures of 3e4 cancel
  EXPECT_LT((found.moment - moment).norm(), 1e-10 * lift.norm());
}

TEST(HydrostaticLoad, RefusesFacesThatStayDry) {
  const ElasticityProblem p = problem(testing::distorted_box(), {.degree = {2, 2, 2}}, steel);
  const auto top = boundary(p.discretization.model, "z_max");
  EXPECT_ERROR(hydrostatic_load("water", top, {1000, {0, 0, 0.5}}, p.discretization),
               ErrorCode::invalid_argument, "wets none");
  EXPECT_ERROR(hydrostatic_load("water", top, {-1, {0, 0, 5}}, p.discretization), ErrorCode::invalid_argument,
               "positive density");
}

TEST(RotationLoad, IsTheMassTimesItsMiddlesDistanceFromTheAxis) {
  ElasticityProblem p = problem(testing::distorted_box(), {.degree = {2, 2, 2}}, steel);
  std::vector<PatchId> all;
  for (int i = 0; i < p.discretization.patch_count(); ++i) all.emplace_back(i);
  const Rotation rotation{{2, 0.5, 0}, {0, 0, 5}, 30};
  p.volume_loads = rotation_load("spin", all, rotation, p.materials);
  Vector3d total = Vector3d::Zero();
  for (const VolumeLoad& load : p.volume_loads) total += total_force(load, p.discretization, 8);
  const Vector3d expected(7850 * 900 * (0.5 - 2), 0, 0);
  EXPECT_LT((resultant(p, 8).force - expected).norm(), 1e-10 * expected.norm());
  EXPECT_LT((total - expected).norm(), 1e-10 * expected.norm());
}

TEST(RotationLoad, NeedsADensityAndAnAxis) {
  std::vector<Material> light = {isotropic(1, 0.3)};
  EXPECT_ERROR(rotation_load("spin", {PatchId(0)}, {.speed = 1}, light), ErrorCode::invalid_argument,
               "no density");
  EXPECT_ERROR(rotation_load("spin", {PatchId(0)}, {.axis = {0, 0, 0}}, light), ErrorCode::invalid_argument,
               "no direction");
}

}  // namespace
}  // namespace isopatch::iga
