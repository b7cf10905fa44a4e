// Patches whose faces are one surface, but whose elements, parameters or outlines there do not agree: linear
// fields must go through such interfaces unchanged, waves with the order of matching ones.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "iga/solution/natural_modes.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/known_problem.hpp"
#include "verification/suites/known_problems.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/moved_patches.hpp"

namespace isopatch::verification {
namespace {

using geometry::MultiPatch;
using iga::Coupling;

const Tolerance of_plane_interfaces = round_off(3e4, "assembling and solving");
// 1.6e-10 at p = 3.
const Tolerance of_curved_interfaces(1e-9, "quadrature of rational functions");

struct NonMatchingModel {
  std::string name;
  MultiPatch model;
  std::vector<std::string> held;
};

MultiPatch kept_apart(const geometry::PatchSet& below, const geometry::PatchSet& above) {
  return geometry::connect(together(below, above), {.keep_non_matching = true});
}

// Two boxes of 2 x 1, one on the other, of so many patches; what is regular has lines of elements that meet
// the other box's at no angle.
MultiPatch boxes(std::array<int, 3> below, std::array<int, 3> above, double distortion) {
  return kept_apart(
      geometry::box_model({.size = {2, 1, 1}, .patches = below, .distortion = distortion, .seed = 3}),
      geometry::box_model(
          {.size = {2, 1, 0.8}, .origin = {0, 0, 1}, .patches = above, .distortion = distortion, .seed = 8}));
}

// A tube's sector of two layers, divided into other arcs in each: the same cylinder in other rational
// parameters.
MultiPatch layers(int inside, int outside, double degrees = 60) {
  const auto layer = [&](double from, double to, int patches) {
    return geometry::cylinder_model({.inner_radius = from,
                                     .outer_radius = to,
                                     .height = 0.5,
                                     .angle = Angle::degrees(degrees),
                                     .patches_around = patches});
  };
  return kept_apart(layer(1.5, 2, inside), layer(2, 2.4, outside));
}

std::vector<NonMatchingModel> models() {
  return {{"T-joint", boxes({1, 1, 1}, {2, 1, 1}, 0), {"x_min", "y_max, second"}},
          {"distorted T-joint", boxes({1, 1, 1}, {2, 1, 1}, 0.2), {"x_min", "y_max, second"}},
          {"3 patches on 2", boxes({2, 1, 1}, {3, 1, 1}, 0.1), {"x_min", "y_max, second"}},
          {"arcs", layers(1, 2), {"start", "bottom, second"}},
          {"3 arcs around 2", layers(2, 3), {"start", "bottom, second"}}};
}

bool is_curved(const NonMatchingModel& model) {
  return model.model.patch(PatchId(0)).is_rational();
}

iga::ElasticityProblem pulled(const NonMatchingModel& m, const LinearField& field, int degree) {
  const iga::Material material = iga::isotropic(1e9, 0.3);
  iga::ElasticityProblem p = unloaded(m.model, {.degree = {degree, degree, degree}, .refine = 1}, material);
  p.supports = {{m.held[0], faces_of(m.model, m.held[0]), field.prescribed()}};
  std::vector<geometry::PatchFace> loaded = m.model.boundary_faces();
  for (const geometry::PatchFace& face : p.supports[0].faces) std::erase(loaded, face);
  p.surface_loads = {{"stress", loaded,
                      [stress = field.stress(material)](const Eigen::Vector3d&, const Eigen::Vector3d& n)
                          -> Eigen::Vector3d { return stress * n; }}};
  return p;
}

TEST(NonMatching, LinearFields) {
  const LinearField field = generic_linear_field();
  for (const NonMatchingModel& m : models())
    for (const int degree : {1, 2, 3}) {
      if (is_curved(m) && degree < 2) continue;
      for (const Coupling coupling : iga::all_couplings) {
        const iga::ElasticitySolution solution =
            iga::solve_elasticity(pulled(m, field, degree), {.coupling = coupling});
        const std::string of = fmt::format("{}, p = {}, {}", m.name, degree, iga::name(coupling));
        expect(Claim{of + ": largest error of a coefficient of u",
                     "",
                     ReferenceKind::exact,
                     "linear field",
                     0,
                     coefficient_error(solution.field, field),
                     is_curved(m) ? of_curved_interfaces : of_plane_interfaces,
                     {}});
      }
    }
}

// A small sector beside the wave: on larger ones coarse meshes converge faster than they will in the end.
NonMatchingModel small_arcs() {
  return {"arcs", layers(1, 2, 20), {"start", "bottom, second"}};
}

void expect_orders_of(const NonMatchingModel& m, const Levels& levels) {
  expect_orders(manufactured(m.name, m.model, m.held), levels);
}

// What is not there yet must be said.
TEST(NonMatching, RefusesWhatItCannot) {
  const NonMatchingModel m = models().front();
  iga::ElasticityProblem p = pulled(m, generic_linear_field(), 1);
  EXPECT_ERROR(iga::natural_modes(p, {}), ErrorCode::unsupported, "natural modes are not for");
  p.temperatures = {{"warm", all_patches(m.model), {100, Eigen::Vector3d::Zero()}}};
  EXPECT_ERROR(iga::solve_elasticity(p, {}), ErrorCode::unsupported, "temperatures are not for");
}

TEST(NonMatching, Orders) {
  for (const NonMatchingModel& m : models())
    if (!is_curved(m)) expect_orders_of(m, {1, {4, 6, 8, 12}});
  expect_orders_of(models()[1], {2, {6, 8, 10, 12}});
}

TEST(FullNonMatching, Orders) {
  for (const NonMatchingModel& m : models()) {
    if (is_curved(m)) continue;
    expect_orders_of(m, {2, {6, 8, 10, 12}});
    expect_orders_of(m, {3, {4, 6, 8, 10}});
  }
  expect_orders_of(small_arcs(), {2, {6, 8, 10, 12}});
  expect_orders_of(small_arcs(), {3, {4, 6, 8, 10}});
}

}  // namespace
}  // namespace isopatch::verification
