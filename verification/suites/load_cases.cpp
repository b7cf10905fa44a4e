// Load cases and combinations against runs of their own; resultants of sections, moments and masses against
// statics.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

const std::string file = "verification/studies/cantilever_cases.toml";

struct Way {
  std::string name;
  std::vector<std::string> set;
  Tolerance allowed;  // between loads solved for together and alone
};

const Tolerance of_factors = round_off(1e3, "factors of one matrix, for a load and for sums of loads");
const Tolerance of_iterations = {1e-9,
                                 "iterations stop at residuals of 1e-10; loads with few of them differ less"};

const std::vector<Way> ways = {
    {"cholmod", {"coupling.method=elimination", "solver.method=cholmod"}, of_factors},
    {"cg, matrix-free",
     {"coupling.method=elimination", "solver.method=cg", "solver.operator=matrix_free"},
     of_iterations},
    {"cg, assembled",
     {"coupling.method=elimination", "solver.method=cg", "solver.operator=assembled"},
     of_iterations},
    {"mumps", {"coupling.method=lagrange", "solver.method=mumps"}, of_factors},
    {"minres", {"coupling.method=lagrange", "solver.method=minres"}, of_iterations}};

// As the study has them: loads by their places in the file, with factors.
struct Alone {
  std::string name;
  std::vector<double> factors;  // of weight, end, pull, side
};

// The study with all loads in one case, scaled.
std::vector<std::string> alone(const Way& way, const Alone& one) {
  std::vector<std::string> set = way.set;
  for (std::size_t i = 0; i < 4; ++i) set.push_back(fmt::format("load.{}.case=all", i));
  set.push_back("combination=[]");
  set.push_back(fmt::format("load.0.gravity=[0,0,{:.17g}]", -9.81 * one.factors[0]));
  set.push_back(fmt::format("load.1.force=[0,0,{:.17g}]", -1000 * one.factors[1]));
  set.push_back(fmt::format("load.2.traction=[{:.17g},0,0]", 1e7 * one.factors[2]));
  set.push_back(fmt::format("load.3.pressure={:.17g}", 1e5 * one.factors[3]));
  return set;
}

TEST(LoadCases, AreThoseOfTheirOwnRuns) {
  const std::vector<Alone> all = {{"weight", {1, 0, 0, 0}},
                                  {"end", {0, 1, 0, 0}},
                                  {"pull", {0, 0, 1, 1}},
                                  {"design", {1.35, 1.5, -0.9, -0.9}}};
  for (const Way& way : ways) {
    const SolvedStudy together = solved(file, way.set);
    const auto cases = app::cases_of(together.run);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const SolvedStudy own = solved(file, alone(way, all[i]));
      const iga::ElasticityResults &a = cases[i].solution.results, &b = own.run.solution.results;
      const auto claim = [&](const char* what, const char* unit, double reference, double value) {
        expect(Claim{fmt::format("{} of {}, {}", what, all[i].name, way.name), unit,
                     ReferenceKind::other_method, "a run of its own", reference, value, way.allowed,
                     together.named});
      };
      claim("energy", "J", b.internal_energy, a.internal_energy);
      claim("largest displacement", "m", b.max_displacement.value, a.max_displacement.value);
      claim("largest von Mises stress", "Pa", b.max_von_mises.value, a.max_von_mises.value);
      claim("reaction", "N", b.reactions[0].force.norm(), a.reactions[0].force.norm());
    }
  }
}

// Equilibrium of the part beyond x = 0.25 m, whatever the elements.
TEST(LoadCases, SectionsAndReactionsBalanceTheLoads) {
  constexpr double weight = 7850 * 9.81 * 0.01;  // N/m
  for (const std::string coupling : {"elimination", "lagrange"}) {
    const SolvedStudy s = solved(file, {"coupling.method=" + coupling});
    const auto cases = app::cases_of(s.run);
    const auto claim = [&](const std::string& what, const char* unit, double reference, double value,
                           const Tolerance& allowed) {
      expect(Claim{fmt::format("{}, {}", what, coupling), unit, ReferenceKind::closed_form, "statics",
                   reference, value, allowed, s.named});
    };
    const Tolerance of_sums = round_off(100, "a sum over points of quadrature");
    // Stresses are in equilibrium in the mean over elements, not at a plane inside: at p = 3 to 1e-4.
    const auto& of_weight = cases[0].sections[0].forces;
    claim("shear force of the weight", "N", -weight * 0.75, of_weight.force[2], 1e-3);
    claim("bending moment of the weight", "N m", weight * 0.75 * 0.375, of_weight.moment[1], 1e-3);
    const auto& of_end = cases[1].sections[0].forces;
    claim("area of the section", "m^2", 0.01, of_end.area, of_sums);
    claim("shear force of the end force", "N", -1000, of_end.force[2], 1e-3);
    claim("bending moment of the end force", "N m", 1000 * 0.75, of_end.moment[1], 5e-4);
    claim("normal force of the pull", "N", 1e5, cases[2].sections[0].forces.force[0], 3e-4);
    // Reactions come from the residual, which is in equilibrium to round-off.
    const Tolerance of_residuals = round_off(1e4, "nodal forces that cancel in the residual");
    const auto moment = [&](std::size_t i) {
      const iga::Reaction& r = cases[i].solution.results.reactions[0];
      return Eigen::Vector3d(r.moment - Eigen::Vector3d(0, 0.05, 0.05).cross(r.force));
    };
    claim("reaction's moment about the wall's middle, weight", "N m", -weight * 0.5, moment(0)[1],
          of_residuals);
    claim("reaction's moment about the wall's middle, end", "N m", -1000, moment(1)[1], of_residuals);
    claim("mass", "kg", 78.5, s.run.built.mass->mass, of_sums);
    claim("moment of inertia about y", "kg m^2", 78.5 / 12 * 1.01, s.run.built.mass->inertia(1, 1), of_sums);
  }
}

// Lame's cylinder, p = 10 inside radius 1, b = 2, height 0.5: hoop stress is the largest principal stress,
// radial the smallest, and a section through the wall carries p a h.
TEST(LoadCases, StressMeasuresOfTheThickCylinder) {
  const SolvedStudy s = solved("examples/thick_cylinder/study.toml",
                               {"discretization.degree=4", "material.0.poisson=0.3", "material.0.yield=20",
                                "section=[{point=[1,1,0.25],normal=[-1,1,0]}]"});
  const iga::ElasticityResults& results = s.run.solution.results;
  const auto claim = [&](const char* what, const char* unit, double reference, double value,
                         const Tolerance& allowed) {
    expect(Claim{what, unit, ReferenceKind::closed_form, "Lame", reference, value, allowed, s.named});
  };
  claim("largest principal stress", "Pa", 50.0 / 3, results.peaks.tension.value, 1e-4);
  claim("smallest principal stress", "Pa", -10, -results.peaks.compression.value, 1e-4);
  claim("largest Tresca stress", "Pa", 80.0 / 3, results.peaks.tresca.value, 5e-5);
  // Plane strain: s_zz = nu (s_rr + s_tt) = 2.
  const double mises = std::sqrt(0.5 * (80.0 / 3 * 80.0 / 3 + 12.0 * 12.0 + 44.0 / 3 * 44.0 / 3));
  claim("safety factor", "", 20 / mises, 1 / results.peaks.utilization.value, 5e-5);
  // The plane is one of symmetry, where the hoop force is in equilibrium exactly.
  const Tolerance of_a_plane = round_off(1e3, "assembling, solving and summing over the plane");
  const app::SectionValues& wall = s.run.sections[0];
  claim("area of a cut through the wall", "m^2", 0.5, wall.forces.area, of_a_plane);
  claim("hoop force on it", "N", 5, wall.forces.force.dot(wall.plane.normal), of_a_plane);
}

}  // namespace
}  // namespace isopatch::verification
