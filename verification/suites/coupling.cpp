// Elimination and multipliers are two ways to hold patches together: they must agree, and multipliers must be
// the forces that statics asks for.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>

#include "geometry/base/larger.hpp"
#include "iga/problem/loads.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/node_forces.hpp"
#include "verification/suites/solved_study.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

// Direct solvers refine in extended precision, so that round-off of the systems is left: 4e-12 of TERRIFIC,
// 1e-12 of generated models, 1e-16 of straight ones.
const Tolerance of_both_solves = round_off(1e4, "assembling and solving both systems");

// A study solved with both couplings.
struct BothWays {
  std::string name;
  ClaimStudy lagrange_study;
  app::BuiltProblem built;
  iga::ElasticitySolution elimination;
  iga::ElasticitySolution lagrange;
  Tolerance allowed = of_both_solves;
};

BothWays solved_both_ways(const std::string& name, const std::string& file,
                          std::vector<std::string> overrides) {
  overrides.emplace_back("coupling.method=lagrange");
  const SolvedStudy tied = solved(file, overrides);
  overrides.back() = "coupling.method=elimination";
  return {name, tied.named, tied.run.built, solved(file, overrides).run.solution, tied.run.solution};
}

void expect_agreement(const BothWays& s) {
  const auto claim = [&](const std::string& what, const char* unit, double reference, double value) {
    expect(Claim{s.name + ", multipliers: " + what, unit, ReferenceKind::other_method, "elimination",
                 reference, value, s.allowed, s.lagrange_study});
  };
  claim("energy", "J", s.elimination.results.internal_energy, s.lagrange.results.internal_energy);
  claim("largest displacement", "m", s.elimination.results.max_displacement.value,
        s.lagrange.results.max_displacement.value);
  claim("largest difference of a coefficient of u", "", 0,
        coefficient_difference(s.elimination.field, s.lagrange.field));
  claim("jump of u between coincident control points", "", 0, largest_jump(s.built.problem, s.lagrange));
  claim("largest difference from multipliers recovered after elimination", "", 0,
        multiplier_difference(s.elimination.multipliers, s.lagrange.multipliers));
}

// Every patch that no support touches is held by its multipliers alone.
void expect_equilibrium(const BothWays& s) {
  const Eigen::Matrix3Xd forces = node_forces(s.built.problem, s.lagrange.multipliers);
  const Eigen::Matrix3Xd loads = iga::load_vector(s.built.problem);
  const std::vector<int> free = untouched_patches(s.built.problem);
  ASSERT_FALSE(free.empty()) << s.name;
  const double size =
      resultant(s.built.problem, loads.cwiseAbs(), all_patches(s.built.problem.discretization.model))
          .force.norm();
  double force = 0, moment = 0;
  for (const int patch : free) {
    const Resultant r = resultant(s.built.problem, forces + loads, {PatchId(patch)});
    force = larger(force, r.force.norm() / size);
    moment = larger(moment, r.moment.norm() / (size * s.built.problem.discretization.model.size()));
  }
  const std::string of =
      fmt::format("{}, multipliers and loads on each of {} patches without support: ", s.name, free.size());
  expect(Claim{of + "force left over", "", ReferenceKind::exact, "equilibrium", 0, force, s.allowed,
               s.lagrange_study});
  expect(Claim{of + "moment left over", "", ReferenceKind::exact, "equilibrium", 0, moment, s.allowed,
               s.lagrange_study});
}

// An interface that cuts a part in two carries all that loads the piece without support.
void expect_cuts(const BothWays& s, std::size_t count) {
  const iga::ElasticityProblem& problem = s.built.problem;
  const Eigen::Matrix3Xd forces = node_forces(problem, s.lagrange.multipliers);
  const Eigen::Matrix3Xd loads = iga::load_vector(problem);
  const std::vector<Cut> cuts = cuts_of(problem);
  EXPECT_EQ(cuts.size(), count) << s.name;
  for (const Cut& cut : cuts) {
    const Resultant carried = resultant(problem, forces, cut.beyond);
    const Resultant asked = resultant(problem, loads, cut.beyond);
    const auto claim = [&](const char* what, const char* unit, const Eigen::Vector3d& carried_part,
                           const Eigen::Vector3d& asked_part) {
      const Eigen::Vector3d direction = asked_part.normalized();
      const double along = -carried_part.dot(direction);
      const std::string of = fmt::format("{}, interface {} = {}: {} of the multipliers", s.name,
                                         cut.first_label, cut.second_label, what);
      expect(Claim{of, unit, ReferenceKind::exact, "loads on the piece beyond it", asked_part.norm(), along,
                   s.allowed, s.lagrange_study});
      expect(Claim{of + ", part across", "", ReferenceKind::exact, "loads on the piece beyond it", 0,
                   (carried_part + along * direction).norm() / asked_part.norm(), s.allowed,
                   s.lagrange_study});
    };
    claim("force", "N", carried.force, asked.force);
    claim("moment", "N m", carried.moment, asked.moment);
  }
}

TEST(Coupling, GeneratedModels) {
  for (const ModelCase& model : model_cases()) {
    const BothWays s =
        solved_both_ways(model.name, "verification/studies/pulled.toml", pulled_overrides(model));
    expect_agreement(s);
    expect_equilibrium(s);
  }
}

// Models that studies make of others by attaching patches, of several materials. The cut of the joint
// supports every patch.
TEST(Coupling, PipeJoint) {
  expect_agreement(
      solved_both_ways("pipe joint", "examples/pipe_joint/study.toml", {"discretization.refine=0"}));
}

TEST(Coupling, ChairStandWithRingAndPin) {
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  const BothWays s =
      solved_both_ways("chair stand with ring and pin", "examples/chair_stand_a/study.toml", {});
  expect_agreement(s);
  expect_equilibrium(s);
}

TEST(Coupling, InterfacesThatCutAPartInTwo) {
  for (const auto& [name, count] : {std::pair{"plate", 1u}, std::pair{"bracket", 2u}, std::pair{"link", 4u}})
    expect_cuts(
        solved_both_ways(name, "verification/studies/pulled.toml", pulled_overrides(model_case(name))),
        count);
  const BothWays bar = solved_both_ways("two-material bar", "examples/two_material_bar/study.toml", {});
  expect_agreement(bar);
}

// The leg of 1 m^3 steel carries its weight and a traction on 1 m^2.
TEST(Coupling, ForceThroughTheBracket) {
  const BothWays s = solved_both_ways("bracket", "verification/studies/pulled.toml",
                                      pulled_overrides(model_case("bracket")));
  const Eigen::Matrix3Xd forces = node_forces(s.built.problem, s.lagrange.multipliers);
  for (const Cut& cut : cuts_of(s.built.problem)) {
    if (cut.beyond.size() != 1) continue;
    const Eigen::Vector3d carried = resultant(s.built.problem, forces, cut.beyond).force;
    const Eigen::Vector3d loads(10e6, -2e6, 5e6 - 7850 * 9.81);
    for (int d = 0; d < 3; ++d)
      expect(Claim{fmt::format("bracket, force of the multipliers on the loaded leg along {}", "xyz"[d]), "N",
                   ReferenceKind::closed_form, "traction times area, and weight", -loads[d], carried[d],
                   s.allowed, s.lagrange_study});
  }
}

TEST(Coupling, Terrific) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  const BothWays s =
      solved_both_ways("TERRIFIC, p = 2", "examples/terrific/study.toml", {"discretization.degree=2"});
  expect_agreement(s);
  expect_equilibrium(s);
}

TEST(Coupling, ChairStand) {
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  const BothWays s = solved_both_ways("chair stand", "examples/chair_stand/study.toml", {});
  expect_agreement(s);
  expect_equilibrium(s);
}

TEST(FullCoupling, GeneratedModelsOfDegreeThree) {
  for (const ModelCase& model : model_cases()) {
    std::vector<std::string> overrides = pulled_overrides(model);
    overrides.insert(overrides.end(), {"discretization.degree=3", "discretization.refine=2"});
    const BothWays s = solved_both_ways(model.name + ", p = 3, refined twice",
                                        "verification/studies/pulled.toml", overrides);
    expect_agreement(s);
    expect_equilibrium(s);
  }
}

TEST(FullCoupling, ChairStandFromSolids) {
  ISOPATCH_NEEDS_DATA("chair_stand/solids");
  // Both are iterated, to so little that round-off is left: at 1e-10 forces differ by 6e-9.
  BothWays s = solved_both_ways("chair stand from solids", "examples/chair_stand_solids/study.toml",
                                {"solver.tolerance=1e-12"});
  s.allowed = round_off(5e5, "assembling and solving both systems of degree 3 and of large condition");
  expect_agreement(s);
  expect_equilibrium(s);
}

// Two other parts of G+Smo, of 15 cubic patches each, which fit only to 5e-6 of their size: held in one eye,
// loaded in the other.
TEST(FullCoupling, LooselyFittedParts) {
  for (const auto& [name, held, loaded] :
       {std::tuple{"terrificPart01_vol", "0:back", "2:back"}, {"terrificPart02_vol", "2:front", "0:back"}}) {
    const std::string file = fmt::format("terrific/{}.xml", name);
    ISOPATCH_NEEDS_DATA(file);
    const BothWays s = solved_both_ways(
        name, "examples/terrific/study.toml",
        {"model.file=" + isopatch::test::data_file(file).string(), "model.same_point=1e-5",
         fmt::format("support.0.faces=[\"{}\"]", held), fmt::format("load.0.faces=[\"{}\"]", loaded)});
    expect_agreement(s);
    expect_equilibrium(s);
  }
}

TEST(FullCoupling, TerrificOfDegreeThree) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  // Both are iterated, to so little that round-off is left: at 1e-10 forces differ by 3e-8.
  BothWays s =
      solved_both_ways("TERRIFIC, p = 3", "examples/terrific/study.toml", {"solver.tolerance=1e-12"});
  s.allowed = round_off(3e5, "assembling and solving both systems of degree 3 and of large condition");
  expect_agreement(s);
  expect_equilibrium(s);
}

}  // namespace
}  // namespace isopatch::verification
