#include "iga/post/stress_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/base/error.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "iga/post/face_stresses.hpp"
#include "iga/post/internal_forces.hpp"
#include "iga/post/results.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;
using testing::boundary;
using ::testing::HasSubstr;
using testing::problem;

const Material tube_steel = isotropic(205e9, 0.29);

TEST(LargestStress, OfAThickCylinderIsLamesAtTheBore) {
  const geometry::MultiPatch model = geometry::connect(geometry::cylinder_model());
  ElasticityProblem p = problem(model, {.degree = {4, 4, 2}, .refine = 2}, tube_steel);
  for (const char* plane : {"start", "end", "bottom", "top"})
    p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
  p.surface_loads = {pressure_load("pressure", boundary(model, "inner"), 3e6)};
  const Extremum found = solve_elasticity(p).results.max_von_mises;
  // Radii 1 and 2, plane strain.
  const double radial = -3e6, hoop = 5e6, axial = 0.29 * (radial + hoop);
  const double exact = von_mises(Eigen::Vector3d(radial, hoop, axial).asDiagonal());
  EXPECT_NEAR(found.value / exact, 1, 1e-3);
  EXPECT_NEAR(found.place.head<2>().norm(), 1, 1e-12);
}

TEST(LargestStress, OfEqualOnesIsTheFirstByPatchAndParameter) {
  const Extremum first{5, {0, 0, 0}, 1, {0.9, 0.1, 0}};
  const Extremum higher{5 * (1 + 1e-12), {1, 0, 0}, 1, {0.2, 0.2, 0}};
  const Extremum other_patch{5 * (1 + 1e-12), {1, 0, 0}, 2, {0, 0, 0}};
  const Extremum truly_larger{5.001, {1, 0, 0}, 3, {0, 0, 0}};
  EXPECT_EQ(larger(first, higher).parameter, first.parameter);
  EXPECT_EQ(larger(higher, first).parameter, first.parameter);
  EXPECT_EQ(larger(other_patch, first).patch, 1);
  EXPECT_EQ(larger(first, truly_larger).patch, 3);
  EXPECT_EQ(larger(Extremum{}, first).patch, 1);
}

TEST(LargestValue, IsNanWhereOneIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Extremum five{5, {0, 0, 0}, 1, {0, 0, 0}}, none{nan, {0, 0, 0}, 2, {0, 0, 0}};
  EXPECT_TRUE(std::isnan(larger(five, none).value));
  EXPECT_TRUE(std::isnan(larger(none, five).value));
  EXPECT_TRUE(std::isnan(larger(none, none).value));
}

TEST(LargestValue, OfDisplacementsIsNanWhereACoefficientIs) {
  const geometry::MultiPatch model = geometry::connect(geometry::box_model({.patches = {2, 1, 1}}));
  const Discretization d = discretize(model, {.degree = {2, 2, 2}});
  ElasticField field{d.patches, {}, {tube_steel, tube_steel}};
  for (const NurbsVolume& patch : d.patches)
    field.displacement.push_back(Eigen::Matrix3Xd::Ones(3, patch.size()));
  EXPECT_NEAR(max_displacement(field).value, std::sqrt(3), 1e-12);
  for (std::size_t p = 0; p < 2; ++p) {
    ElasticField broken = field;
    broken.displacement[p](1, 4) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(max_displacement(broken).value)) << p;
  }
}

// A bar pulled between symmetry planes has one stress everywhere.
TEST(LargestStress, OfAUniformOneIsAtTheFirstPlaceOfTheFirstPatch) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.patches = {2, 2, 1}, .distortion = 0.3, .curvature = 0.2}));
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, tube_steel);
  for (const char* plane : {"x_min", "y_min", "z_min"})
    p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1e8, 0, 0})};
  const Extremum found = solve_elasticity(p).results.max_von_mises;
  EXPECT_EQ(found.patch, 0);
  EXPECT_EQ(found.parameter, geometry::Parameter<3>(0, 0, 0));
}

// The unit cube with one edge pushed in so far that the map is folded there, but at no Gauss point.
geometry::MultiPatch folded_at_an_edge() {
  const NurbsVolume cube;
  Eigen::Matrix3Xd points = cube.control_points();
  for (int i = 0; i < 8; ++i)
    if (points(0, i) == 1 && points(1, i) == 1) points.col(i).head<2>() << 0.499, 0.499;
  return geometry::connect({{NurbsVolume(cube.knots(), points)}, {}, {}});
}

TEST(LargestStress, IsNotSoughtWhereTheMapIsFolded) {
  ElasticityProblem p = problem(folded_at_an_edge(), {.degree = {2, 2, 2}}, tube_steel);
  const auto side = [](geometry::Side s) { return std::vector<geometry::PatchFace>{{PatchId(0), s}}; };
  p.supports = {{"held", side(geometry::Side::west), PrescribedDisplacement{}}};
  p.surface_loads = {constant_traction("pull", side(geometry::Side::south), {0, -1e6, 0})};
  const ElasticityResults results = solve_elasticity(p).results;
  EXPECT_GT(results.left_out.folded, 0);
  EXPECT_EQ(results.left_out.collapsed, 0);
  EXPECT_EQ(results.left_out.worst.patch, 0);
  EXPECT_GT(results.left_out.worst.value, 0);  // a negative Jacobian
  EXPECT_GT(results.left_out.worst.parameter[0], 0.8);
  EXPECT_GT(results.left_out.worst.parameter[1], 0.8);
  EXPECT_GT(results.max_von_mises.value, 1e5);
  double scaled = 0;
  const auto& patch = p.discretization.patches[0];
  EXPECT_EQ(map_state(patch.jacobian(results.max_von_mises.parameter), scaled), MapState::sound);
}

TEST(LargestStress, CollapsedEdgesCountApart) {
  const NurbsVolume cube;
  Eigen::Matrix3Xd points = cube.control_points();
  for (int i = 0; i < 8; ++i)
    if (points(0, i) == 0) points(1, i) = 0;  // a wedge whose edge is the z axis
  const geometry::MultiPatch model = geometry::connect({{NurbsVolume(cube.knots(), points)}, {}, {}});
  const Discretization d = discretize(model, {.degree = {2, 2, 2}});
  ElasticField field{d.patches, {0.001 * d.patches[0].control_points()}, {tube_steel}};
  const LeftOut left_out = stresses_on_faces(field).left_out;
  EXPECT_EQ(left_out.folded, 0);
  EXPECT_GT(left_out.collapsed, 0);
  EXPECT_EQ(left_out.worst.patch, -1);
}

TEST(LargestStress, ANumberThatIsNoneIsAnError) {
  const Discretization d = discretize(geometry::connect(geometry::box_model()), {.degree = {2, 2, 2}});
  Eigen::Matrix3Xd u = 0.001 * d.patches[0].control_points();
  u(1, 13) = std::numeric_limits<double>::quiet_NaN();
  const auto expect_error = [](const auto& action) {
    try {
      action();
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::singular_system);
      EXPECT_THAT(error.what(), HasSubstr("patch 0"));
    }
  };
  expect_error([&] { internal_forces(d, {tube_steel}, u); });
  expect_error([&] { stresses_on_faces({d.patches, {u}, {tube_steel}}); });
}

TEST(IdleLoads, ArePressuresOnFacesThatAreHeld) {
  const geometry::MultiPatch model = geometry::connect(geometry::box_model());
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, tube_steel);
  p.supports = {{"clamp", boundary(model, "x_min"), PrescribedDisplacement{}},
                {"slide", boundary(model, "y_min"), PlaneSupport{}}};
  p.surface_loads = {pressure_load("on the clamp", boundary(model, "x_min"), 1e6),
                     pressure_load("against the plane", boundary(model, "y_min"), 1e6),
                     constant_traction("along the plane", boundary(model, "y_min"), {0, 0, 1e6}),
                     pressure_load("free", boundary(model, "x_max"), 1e6)};
  EXPECT_THAT(solve_elasticity(p).results.idle_loads,
              ::testing::ElementsAre("on the clamp", "against the plane"));
}

}  // namespace
}  // namespace isopatch::iga
