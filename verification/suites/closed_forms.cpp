// Problems whose solution is a formula, as studies that a user could have written.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

// Lame's thick-walled cylinder in plane strain: a = 1, b = 2, height 0.5, a quarter, p = 10 inside, E = 1000.
struct Cylinder {
  double nu;
  double factor = (1 + nu) / 1000 * 10.0 / 3;  // (1 + nu) / E p a^2 / (b^2 - a^2)

  double radial_displacement(double r) const { return factor * ((1 - 2 * nu) * r + 4 / r); }
  // Half the pressure's work on the inner face of the quarter.
  double energy() const { return 0.5 * 10 * radial_displacement(1) * std::numbers::pi / 2 * 0.5; }
};

// What each degree reaches with eight elements through the wall: nearly incompressible material locks low
// degrees.
double allowed_of_cylinder(int degree, double nu) {
  if (degree == 2) return nu < 0.4 ? 2e-5 : 1e-2;
  if (degree == 3) return nu < 0.4 ? 1e-7 : 1e-4;
  return nu < 0.4 ? 5e-10 : 1e-6;
}

// Returns the error of u_r at the inner wall.
double expect_cylinder(int degree, double nu) {
  const std::string file = "examples/thick_cylinder/study.toml";
  const SolvedStudy s = solved(
      file, {fmt::format("discretization.degree={}", degree), fmt::format("material.0.poisson={}", nu)});
  const Cylinder exact{nu};
  const double allowed = allowed_of_cylinder(degree, nu);
  const std::string of = fmt::format(", nu = {}, p = {}", nu, degree);
  const auto claim = [&](const std::string& what, const char* unit, double reference, double value,
                         double within) {
    expect(Claim{what + of, unit, ReferenceKind::closed_form, "Lame", reference, value, within, s.named});
  };
  claim("u_r at the inner wall", "m", exact.radial_displacement(1),
        s.probe("inner wall").values.displacement[0], allowed);
  claim("u_r at the outer wall", "m", exact.radial_displacement(2),
        s.probe("outer wall").values.displacement[0], allowed);
  claim("energy", "J", exact.energy(), s.run.solution.results.internal_energy, allowed);
  // Stress is a derivative: one order less.
  const double of_stress = degree == 3 ? 1e-3 : 1e-4;
  if (nu < 0.4 && degree >= 3) {
    claim("s_tt at the inner wall", "Pa", 50.0 / 3, s.probe("inner wall").values.stress(1, 1), of_stress);
    claim("s_rr at the inner wall", "Pa", -10, s.probe("inner wall").values.stress(0, 0), of_stress);
  }
  return std::abs(s.probe("inner wall").values.displacement[0] / exact.radial_displacement(1) - 1);
}

TEST(ClosedForms, ThickCylinder) {
  for (const int degree : {2, 3, 4}) {
    const double error = expect_cylinder(degree, 0.3);
    const double locked = expect_cylinder(degree, 0.4999);
    report(
        Figure{.what = fmt::format("locking: error of u_r at nu = 0.4999 over that at 0.3, p = {}", degree),
               .unit = "",
               .kind = ReferenceKind::closed_form,
               .source = "Lame",
               .value = locked / error,
               .why = "displacements alone lock where material is nearly incompressible; both fall with p"});
  }
}

TEST(ClosedForms, TwoMaterialBar) {
  const SolvedStudy s = solved("examples/two_material_bar/study.toml");
  // Strain p / M in each half, M = lambda + 2 mu, because the sides are guided.
  const double aluminium = 0.01 / (54.0 + 2 * 27.8);
  const double plastic = 0.01 / (3.19 + 2 * 0.899);
  const auto claim = [&](const std::string& what, const char* unit, double reference, double value) {
    expect(Claim{what, unit, ReferenceKind::closed_form, "p / M1 + p / M2", reference, value,
                 round_off(10, "assembling and solving where the solution lies in the space"), s.named});
  };
  claim("u at the joint", "m", aluminium, s.probe("joint").values.displacement[0]);
  claim("u at the end", "m", aluminium + plastic, s.probe("end").values.displacement[0]);
  claim("energy", "J", 0.5 * 0.01e9 * (aluminium + plastic), s.run.solution.results.internal_energy);
  claim("s_xx at the joint", "Pa", 0.01e9, s.probe("joint").values.stress(0, 0));
}

TEST(ClosedForms, HollowSphere) {
  // a = 1, b = 2, p = 1, E = 1000, nu = 0.3: u_r(a) = p a^3 / (E (b^3 - a^3)) ((1 - 2 nu) a + (1 + nu) b^3 /
  // (2 a^2)).
  const double wall = 1.0 / (1000 * 7) * ((1 - 0.6) + 1.3 * 8 / 2);
  const SolvedStudy s = solved("verification/studies/hollow_sphere.toml");
  const auto claim = [&](const std::string& what, const char* unit, double reference, double value,
                         double allowed) {
    expect(Claim{what, unit, ReferenceKind::closed_form, "Lame", reference, value, allowed, s.named});
  };
  claim("u_r at the inner wall", "m", wall, s.probe("inner wall").values.displacement[0], 1e-6);
  claim("energy", "J", 0.5 * wall * std::numbers::pi / 2, s.run.solution.results.internal_energy, 1e-6);
  // p (b^3 / (2 a^3) + 1) a^3 / (b^3 - a^3).
  claim("s_tt at the inner wall", "Pa", 5.0 / 7, s.probe("inner wall").values.stress(1, 1), 2e-3);
}

}  // namespace
}  // namespace isopatch::verification
