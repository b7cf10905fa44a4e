// A linear displacement lies in every isogeometric space on every model, so it must be found exactly: with
// any coupling, any orientation of the patches, prescribed or caused by tractions.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/measures.hpp"
#include "geometry/models/reorient.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

// Degrees 4 and 5 reach 1e-11, tractions on curved faces 3e-11, most models 1e-14.
const Tolerance of_linear_fields =
    round_off(3e4, "assembling and solving, and of integrals of rational functions");
// A sum of many terms loses less than its terms.
const Tolerance of_linear_energies = round_off(300, "the sum of the energy's terms");

double volume_of(const iga::ElasticField& field) {
  double sum = 0;
  for (const geometry::NurbsVolume& patch : field.patches) sum += geometry::volume(patch);
  return sum;
}

// All claims about a solution that must be linear in one material.
void expect_linear(const std::string& of, const iga::ElasticitySolution& solution, const LinearField& exact,
                   const ClaimStudy& study) {
  const iga::Material& material = solution.field.materials[0];
  const double energy = exact.energy_density(material) * volume_of(solution.field);
  expect(Claim{of + ": largest error of a coefficient of u", "", ReferenceKind::exact, "linear field", 0,
               coefficient_error(solution.field, exact), of_linear_fields, study});
  expect(Claim{of + ": energy", "J", ReferenceKind::exact, "stress : strain / 2 times the volume", energy,
               solution.results.internal_energy, of_linear_energies, study});
}

// The field that a study prescribes on the surface.
LinearField held_field(const SolvedStudy& s) {
  const auto& held = std::get<iga::PrescribedDisplacement>(s.run.built.problem.supports[0].condition);
  return {Eigen::Vector3d(*held.value[0], *held.value[1], *held.value[2]), held.gradient};
}

// Prescribed on the whole surface, as a user would write it.
void expect_follows_its_surface(const ModelCase& model, const std::vector<std::string>& more = {}) {
  for (const iga::Coupling coupling : iga::all_couplings) {
    std::vector<std::string> overrides = model.overrides;
    overrides.insert(overrides.end(), more.begin(), more.end());
    overrides.push_back(fmt::format("coupling.method={}", iga::name(coupling)));
    const SolvedStudy s = solved("verification/studies/patch_test.toml", overrides);
    expect_linear(fmt::format("{}, {}", model.name, iga::name(coupling)), s.run.solution, held_field(s),
                  s.named);
  }
}

TEST(PatchTests, DisplacementOnTheWholeSurface) {
  for (const ModelCase& model : every_model_case()) expect_follows_its_surface(model);
  expect_follows_its_surface({"Cook's membrane, 1 thick", {"model.generate=cook"}, "", ""});
}

// As many points as the map of a patch needs: degree + 1 where it is polynomial, more where it is rational.
TEST(PatchTests, DefaultQuadrature) {
  for (const ModelCase& model : every_model_case()) {
    std::vector<std::string> overrides = model.overrides;
    overrides.emplace_back("discretization.points=0");
    const SolvedStudy s = solved("verification/studies/patch_test.toml", overrides);
    expect(Claim{model.name + ", points by default: largest error of a coefficient of u", "",
                 ReferenceKind::exact, "linear field", 0,
                 coefficient_error(s.run.solution.field, held_field(s)), of_linear_fields, s.named});
  }
}

// The linear field held on one boundary and caused by tractions on all other faces.
iga::ElasticityProblem pulled_into(const LinearField& field, const geometry::MultiPatch& model,
                                   const std::string& held) {
  const iga::Material material = iga::isotropic(1e9, 0.3);
  iga::ElasticityProblem p{
      iga::discretize(model, {.degree = {2, 2, 2}, .refine = 1}),
      std::vector<iga::Material>(static_cast<std::size_t>(model.patch_count()), material),
      {},
      {},
      {}};
  p.supports = {{held, faces_of(model, held), field.prescribed()}};
  std::vector<geometry::PatchFace> loaded = model.boundary_faces();
  for (const geometry::PatchFace& face : p.supports[0].faces) std::erase(loaded, face);
  p.surface_loads = {{"stress", loaded,
                      [stress = field.stress(material)](const Eigen::Vector3d&, const Eigen::Vector3d& n)
                          -> Eigen::Vector3d { return stress * n; }}};
  return p;
}

void expect_is_pulled_into_it(const ModelCase& model, const std::string& what,
                              const geometry::PatchSet& set) {
  const LinearField field = generic_linear_field();
  const iga::ElasticityProblem problem = pulled_into(field, geometry::connect(set), model.held);
  for (const iga::Coupling coupling : iga::all_couplings)
    expect_linear(fmt::format("{}, {}, {}", model.name, what, iga::name(coupling)),
                  iga::solve_elasticity(problem, {.coupling = coupling, .quadrature_points = 10}), field, {});
}

TEST(PatchTests, TractionOnAllFacesButOneBoundary) {
  for (const ModelCase& model : every_model_case())
    expect_is_pulled_into_it(model, "by tractions", patches_of(model));
}

TEST(PatchTests, RandomlyReorientedPatches) {
  for (const ModelCase& model : every_model_case())
    for (const unsigned seed : {1u, 2u})
      expect_is_pulled_into_it(model, fmt::format("by tractions, reoriented with seed {}", seed),
                               geometry::randomly_reoriented(patches_of(model), seed));
}

TEST(FullPatchTests, DegreesAndRefinement) {
  for (const ModelCase& model : every_model_case())
    for (const auto& [degree, refine] : {std::pair{3, 1}, std::pair{4, 1}, std::pair{2, 2}})
      expect_follows_its_surface(model, {fmt::format("discretization.degree={}", degree),
                                         fmt::format("discretization.refine={}", refine)});
}

}  // namespace
}  // namespace isopatch::verification
