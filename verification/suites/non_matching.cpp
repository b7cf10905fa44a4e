// Patches whose faces are one surface, but whose elements, parameters or outlines there do not agree: linear
// fields must go through such interfaces unchanged, waves with the order of matching ones.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
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
MultiPatch layers(int inside, int outside) {
  const auto layer = [](double from, double to, int patches) {
    return geometry::cylinder_model({.inner_radius = from,
                                     .outer_radius = to,
                                     .height = 0.5,
                                     .angle = Angle::degrees(60),
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
                     {.value = is_curved(m) ? 1e-6 : 1e-9, .reason = "what the issue asks"},
                     {}});
      }
    }
}

TEST(NonMatching, Orders) {
  for (const NonMatchingModel& m : models()) {
    if (is_curved(m)) continue;
    for (const int degree : {1, 2})
      expect_orders(manufactured(m.name, m.model, m.held), {degree, {4, 6, 8}, Coupling::elimination});
  }
}

}  // namespace
}  // namespace isopatch::verification
