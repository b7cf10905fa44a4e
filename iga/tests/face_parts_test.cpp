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
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/load_resultant.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using testing::boundary;
using testing::problem;
using testing::resultant;
using testing::steel;

ElasticityProblem plain_block(const Vector3d& size, int refine, std::array<int, 3> patches = {1, 1, 1}) {
  return problem(geometry::connect(geometry::box_model({.size = size, .patches = patches})),
                 {.degree = {2, 2, 2}, .refine = refine}, steel);
}

double area_on(const ElasticityProblem& p, const std::string& name, const Region& region) {
  return area_of(p.discretization.patches, boundary(p.discretization.model, name), region);
}

TEST(FaceParts, HaveTheAreaOfADisc) {
  for (const int refine : {0, 1, 2, 3}) {
    const ElasticityProblem p = plain_block({1, 1, 1}, refine);
    // Gauss points between smooth graphs converge faster than any power; 1e-8 is what eight a direction leave
    // where a cell has a fourth of the rim.
    for (const double radius : {0.05, 0.2, 0.31, 0.45})
      EXPECT_NEAR(
          area_on(p, "z_max", inside_cylinder({0.52, 0.47, 0}, {0, 0, 3}, radius)) / (pi * radius * radius),
          1, 1e-8)
          << refine << " " << radius;
    EXPECT_NEAR(area_on(p, "z_max", inside_sphere({0.5, 0.5, 0.7}, 0.5)) / (pi * 0.16), 1, 1e-9);
  }
}

TEST(FaceParts, MayTouchSidesOfElements) {
  const ElasticityProblem p = plain_block({1, 1, 1}, 1);
  // The rim touches the sides of all four elements, where it is neither inside nor outside.
  EXPECT_NEAR(area_on(p, "z_max", inside_cylinder({0.25, 0.25, 0}, {0, 0, 1}, 0.25)) / (pi / 16), 1, 1e-7);
  EXPECT_NEAR(area_on(p, "z_max", half_space({0.5, 0, 0}, {1, 0, 0})), 0.5, 1e-14);
  EXPECT_NEAR(area_on(p, "z_max", inside_box({0, 0, 0}, {0.5, 1, 1})), 0.5, 1e-14);
  EXPECT_EQ(area_on(p, "z_max", half_space({1, 0, 0}, {1, 0, 0})), 0);
  EXPECT_EQ(area_on(p, "z_max", half_space({0, 0, 1.1}, {0, 0, 1})), 0);
}

TEST(FaceParts, MayHaveCorners) {
  for (const int refine : {0, 2}) {
    const ElasticityProblem p = plain_block({1, 1, 1}, refine);
    // Cells of 2^-14 of an element at the corners are counted by their middle.
    EXPECT_NEAR(area_on(p, "z_max", inside_box({0.11, 0.23, 0}, {0.77, 0.61, 2})), 0.66 * 0.38, 1e-8);
    EXPECT_NEAR(area_on(p, "z_max", inside_box({0.11, 0.23, 0}, {0.12, 0.24, 2})), 1e-4, 2e-9);
    const Region wedge = half_space({0.3, 0.3, 0}, {1, 2, 0}) & half_space({0.3, 0.3, 0}, {-1, 1, 0});
    // Between the directions (-2, 1) and (1, 1) from (0.3, 0.3), in the unit square.
    EXPECT_NEAR(area_on(p, "z_max", wedge), 0.5 * 0.7 * 0.7 + 0.3 * 0.7 - 0.5 * 0.3 * 0.15, 1e-8);
  }
}

TEST(FaceParts, MayLieOnCurvedFaces) {
  const ElasticityProblem p =
      problem(geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(360)})),
              {.degree = {2, 2, 2}, .refine = 1}, steel);
  // Radius 1, height 0.5; the plane crosses rational elements at 20 degrees and at the opposite place.
  const double t = 20 * pi / 180;
  EXPECT_NEAR(area_on(p, "inner", half_space({0, 0, 0}, {-std::sin(t), std::cos(t), 0})), pi * 0.5, 1e-10);
  EXPECT_NEAR(area_on(p, "inner", half_space({0, 0, 0.1}, {0, 0, -1})), 2 * pi * 0.1, 1e-10);
  // A plane across both: z <= 0.2 + 0.1 x.
  EXPECT_NEAR(area_on(p, "inner", half_space({0, 0, 0.2}, {0.1, 0, -1})), 2 * pi * 0.2, 1e-9);
}

TEST(FaceParts, TakeForcesWhole) {
  ElasticityProblem p = plain_block({1, 1, 1}, 1);
  const auto faces = boundary(p.discretization.model, "z_max");
  const Region disc = inside_cylinder({0.4, 0.45, 0}, {0, 0, 1}, 0.3);
  const Vector3d force(3, -4, 5), centre(0.4, 0.45, 1);
  p.surface_loads = {total_force("pad", faces, force, p.discretization, disc)};
  EXPECT_LT((resultant(p).force - force).norm(), 1e-12);
  EXPECT_LT((resultant(p).moment - centre.cross(force)).norm(), 1e-9);
  p.surface_loads = {pressure_load("pad", faces, 7, disc)};
  EXPECT_LT((resultant(p).force - Vector3d(0, 0, -7 * pi * 0.09)).norm(), 1e-8);
  p.surface_loads = {remote_load("arm", faces,
                                 {.force = force, .moment = {1, 2, 3}, .point = Vector3d(2, 2, 2)},
                                 p.discretization, disc)};
  EXPECT_LT((resultant(p).force - force).norm(), 1e-12);
  EXPECT_LT((resultant(p).moment - Vector3d(1, 2, 3) - Vector3d(2, 2, 2).cross(force)).norm(), 1e-12);
  EXPECT_ERROR(total_force("pad", faces, force, p.discretization, half_space({0, 0, 2}, {0, 0, 1})),
               ErrorCode::invalid_argument, "an area");
}

TEST(FaceParts, EndWhereElementsEnd) {
  ElasticityProblem p = plain_block({2, 1, 1}, 1);
  p.surface_loads = {constant_traction("a", boundary(p.discretization.model, "z_max"), {1, 2, 3},
                                       half_space({1, 0, 0}, {1, 0, 0}))};
  EXPECT_NEAR(resultant(p).force[0], 1, 1e-14);
  EXPECT_NEAR(resultant(p).moment[1], 1 * 1 - 1.5 * 3, 1e-13);
}

TEST(HydrostaticLoad, EndsAtTheSurfaceOfTheLiquidWithinElements) {
  ElasticityProblem p = plain_block({1, 1, 1}, 1);
  p.surface_loads = {hydrostatic_load("water", boundary(p.discretization.model, "x_max"),
                                      {.density = 1000, .surface = {0, 0, 0.37}, .gravity = {0, 0, -10}},
                                      p.discretization)};
  // rho g h^2 / 2, at a third of the depth.
  const double force = 1000 * 10 * 0.37 * 0.37 / 2;
  EXPECT_NEAR(resultant(p).force[0], -force, 1e-12 * force);
  EXPECT_NEAR(resultant(p).moment[1], -force * 0.37 / 3, 1e-12 * force);
}

TEST(PointLoads, WorkOnTheDisplacementOfTheirPlaces) {
  ElasticityProblem p = problem(testing::distorted_box(), {.degree = {2, 2, 2}}, steel);
  const Discretization& d = p.discretization;
  const geometry::Parameter<3> inside = 0.3 * d.patches[3].low() + 0.7 * d.patches[3].high();
  const Vector3d place = d.patches[3].point(inside), force(1, -2, 3);
  p.point_loads = {{"finger", force, {{PatchId(3), inside, 1}}}};
  EXPECT_LT((resultant(p).force - force).norm(), 1e-14);
  EXPECT_LT((resultant(p).moment - place.cross(force)).norm(), 1e-14);
  p.point_loads[0].points[0].patch = PatchId(99);
  EXPECT_ERROR(load_vector(p), ErrorCode::invalid_argument, "finger");
}

TEST(PointLoads, BelongToCases) {
  ElasticityProblem p = plain_block({1, 1, 1}, 0);
  p.point_loads = {{"a", {1, 0, 0}, {{PatchId(0), {0.5, 0.5, 1}, 1}}},
                   {"b", {0, 1, 0}, {{PatchId(0), {0, 0, 1}, 1}}}};
  EXPECT_LT((resultant(of_case(p, {"second", {"b"}, {}})).force - Vector3d(0, 1, 0)).norm(), 1e-15);
}

// A block that half of its lower side holds, pushed from above.
double work_held_on_half(const std::array<int, 3>& elements, bool by_patch,
                         const ElasticityOptions& options = {}) {
  ElasticityProblem p = problem(
      geometry::connect(geometry::box_model({.size = {2, 1, 1}, .patches = {by_patch ? 2 : 1, 1, 1}})),
      {.degree = {2, 2, 2}, .elements_per_direction = elements}, steel);
  const geometry::MultiPatch& model = p.discretization.model;
  Support support{"foot", boundary(model, "z_min"), PrescribedDisplacement{}};
  if (by_patch)
    std::erase_if(support.faces, [](const auto& face) { return face.patch != PatchId(0); });
  else
    support.region = half_space({1, 0, 0}, {-1, 0, 0});
  p.supports = {support};
  p.surface_loads = {constant_traction("push", boundary(model, "z_max"), {1e6, 0, -1e6})};
  const ElasticityResults r = solve_elasticity(p, options).results;
  EXPECT_NEAR(r.reactions[0].force[2], 2e6, 1);
  EXPECT_NEAR(r.internal_energy, r.external_work, 1e-8 * r.external_work);
  return r.external_work;
}

// The rim is met where Greville points lie on it, and to half an element where it is an edge of elements: the
// part that overhangs, whose deflection goes with the fourth power of its length, is then too long by that.
TEST(HeldParts, ComeNearToWhatIsHeldByPatches) {
  const double reference = work_held_on_half({8, 8, 8}, true);
  EXPECT_NEAR(work_held_on_half({9, 5, 5}, false) / reference, 1.03, 0.05);
  const double coarse = work_held_on_half({4, 2, 2}, false) / reference;
  const double fine = work_held_on_half({8, 4, 4}, false) / reference;
  EXPECT_GT(fine, 1);
  EXPECT_LT(fine - 1, 0.5 * (coarse - 1));
  EXPECT_NEAR(work_held_on_half({9, 5, 5}, false, {.coupling = Coupling::lagrange}),
              work_held_on_half({9, 5, 5}, false), 1e-6 * reference);
}

TEST(HeldParts, MoveAndHoldAsWholeFacesWhereTheyAreThese) {
  ElasticityProblem p = plain_block({1, 1, 1}, 1);
  const geometry::MultiPatch& model = p.discretization.model;
  p.supports = {{"floor", boundary(model, "z_min"), PlaneSupport{}},
                {"left", boundary(model, "x_min"), PlaneSupport{}},
                {"back", boundary(model, "y_min"), PlaneSupport{}},
                {"ceiling", boundary(model, "z_max"), PlaneSupport{-0.01}}};
  const double whole = solve_elasticity(p).results.internal_energy;
  for (Support& support : p.supports) support.region = inside_sphere({0.5, 0.5, 0.5}, 1);
  EXPECT_NEAR(solve_elasticity(p).results.internal_energy, whole, 1e-12 * whole);
  p.supports[0].region = inside_sphere({0.5, 0.6, 0}, 0.01);
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument, "smaller than half an element");
}

}  // namespace
}  // namespace isopatch::iga
