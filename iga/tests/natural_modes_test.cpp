#include "iga/solution/natural_modes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/base/tests/expect_error.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using std::numbers::pi;
using testing::boundary;

// nu = 0 lets bars swing along x alone.
const Material simple = isotropic(4, 0, 1, "simple");

// Rollers on all sides but the ends: a rod, whose frequencies along x are (2 n - 1) c / (4 L) with one end
// held.
TEST(NaturalModes, OfARod) {
  const auto model = geometry::connect(geometry::box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}}));
  ElasticityProblem p =
      testing::problem(model, {.degree = {4, 1, 1}, .elements_per_direction = {4, 1, 1}}, simple);
  const PrescribedDisplacement along_x{{std::nullopt, 0.0, 0.0}};
  for (const char* side : {"y_min", "y_max", "z_min", "z_max"})
    p.supports.push_back({side, boundary(model, side), along_x});
  p.supports.push_back({"wall", boundary(model, "x_min"), PrescribedDisplacement{}});
  const NaturalModes found = natural_modes(p, {.number = 2});
  EXPECT_EQ(found.rigid_motions, 0);
  for (int n = 1; n <= 2; ++n)  // the third along x lies above the first in shear
    // c = 2, L = 2; degree 4 on elements of a quarter: far below 1e-5.
    EXPECT_NEAR(found.modes[static_cast<std::size_t>(n - 1)].frequency / ((2 * n - 1) * 2 / 8.0), 1, 1e-5)
        << n;
}

std::vector<double> frequencies(const NaturalModes& found) {
  std::vector<double> result;
  for (const NaturalMode& mode : found.modes) result.push_back(mode.frequency);
  return result;
}

TEST(NaturalModes, OfAFreeCubeHaveSixRigidMotionsAndAllCopies) {
  for (const int patches : {1, 2}) {
    const auto model = geometry::connect(geometry::box_model({.patches = {patches, patches, patches}}));
    const ElasticityProblem p = testing::problem(
        model, {.degree = {3, 3, 3}, .elements_per_direction = {3 - patches, 3 - patches, 3 - patches}},
        isotropic(1, 0.3, 1));
    const NaturalModes found = natural_modes(p, {.number = 12});
    ASSERT_EQ(found.modes.size(), 18u);
    EXPECT_EQ(found.rigid_motions, 6);
    EXPECT_LE(found.worst_orthogonality, 1e-10);
    for (std::size_t i = 0; i < 18; ++i) {
      EXPECT_EQ(found.modes[i].is_rigid, i < 6) << i;
      EXPECT_LE(found.modes[i].residual, 1e-6) << i;
    }
    // Symmetry of a cube: two, three, three, ... copies (torsions E_u, then T_2g and others).
    EXPECT_NEAR(found.modes[6].frequency / found.modes[7].frequency, 1, 1e-9);
    EXPECT_GT(found.modes[8].frequency / found.modes[7].frequency, 1.001);
    EXPECT_NEAR(found.modes[8].frequency / found.modes[10].frequency, 1, 1e-9);
    EXPECT_GE(found.counted, 18);
    // Lame's modes in the three planes are exact for any nu: f = c_s / (sqrt(2) a), here sqrt(mu / 2);
    // on two elements along each edge cubic functions find them within 0.1 %.
    int of_lame = 0;
    for (const NaturalMode& mode : found.modes)
      if (std::abs(mode.frequency / std::sqrt(0.5 / 2.6) - 1) < 1e-3) ++of_lame;
    EXPECT_EQ(of_lame, 3) << fmt::format("{}", fmt::join(frequencies(found), " "));
  }
}

// Euler and Bernoulli: f = (1.8751 / L)^2 sqrt(E I / (rho A)) / (2 pi), twice for a square; slender, so that
// shear takes 0.1 %.
TEST(NaturalModes, OfASquareCantileverComeTwice) {
  const auto model = geometry::connect(geometry::box_model({.size = {40, 1, 1}, .patches = {2, 1, 1}}));
  ElasticityProblem p =
      testing::problem(model, {.degree = {4, 2, 2}, .elements_per_direction = {4, 1, 1}}, simple);
  p.supports = {{"wall", boundary(model, "x_min"), PrescribedDisplacement{}}};
  const NaturalModes found = natural_modes(p, {.number = 4});
  const auto bending = [](double root) { return std::pow(root / 40, 2) * std::sqrt(4 / 12.0) / (2 * pi); };
  EXPECT_NEAR(found.modes[0].frequency / bending(1.8751041), 1, 2e-3);
  EXPECT_NEAR(found.modes[1].frequency / found.modes[0].frequency, 1, 1e-8);
  EXPECT_NEAR(found.modes[2].frequency / bending(4.6940911), 1, 1e-2);
  EXPECT_NEAR(found.modes[3].frequency / found.modes[2].frequency, 1, 1e-8);
}

TEST(NaturalModes, NeedDensitiesAndASensibleNumber) {
  const auto model = geometry::connect(geometry::box_model({}));
  ElasticityProblem p = testing::problem(model, {.degree = {2, 2, 2}}, isotropic(1, 0.3));
  EXPECT_ERROR(natural_modes(p), ErrorCode::invalid_argument, "density");
  p.materials[0].density = 1;
  EXPECT_ERROR(natural_modes(p, {.number = 0}), ErrorCode::invalid_argument, "number of modes is 0");
  EXPECT_ERROR(natural_modes(p, {.number = 200}), ErrorCode::invalid_argument, "fewer than");
}

TEST(NaturalModes, AreRefusedBeforeAnythingIsAssembledWhereMemoryIsShort) {
  const auto model = geometry::connect(geometry::box_model({}));
  const ElasticityProblem p = testing::problem(model, {.degree = {2, 2, 2}}, simple);
  std::vector<std::string> phases;
  const Progress progress{[&](std::string_view phase, double) { phases.emplace_back(phase); }};
  EXPECT_ERROR(natural_modes(p, {.memory_limit = 1e6}, progress), ErrorCode::out_of_memory,
               "modes of 81 unknowns");
  EXPECT_TRUE(phases.empty());
}

}  // namespace
}  // namespace isopatch::iga
