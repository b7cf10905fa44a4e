// The same part in other coordinates, other units or with its patches in another order is the same part: its
// energy must not change.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <optional>
#include <random>

#include "geometry/models/reorient.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/dense_systems.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/moved_patches.hpp"
#include "verification/suites/solved_study.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// The energy is the difference of larger sums where a part bends: Cook's membrane, ten thick, moves by 3e-10,
// other models by 1e-12 and less.
const Tolerance allowed_change = round_off(3e5, "a matrix of condition 1e5 to 1e6 in other coordinates");

// The patches in another order: patch i becomes the order[i]-th.
geometry::PatchSet renumbered(const geometry::PatchSet& set, const std::vector<int>& order) {
  geometry::PatchSet result = set;
  const auto place = [&](PatchId id) { return PatchId(order[static_cast<std::size_t>(id.value)]); };
  for (std::size_t p = 0; p < order.size(); ++p)
    result.patches[static_cast<std::size_t>(order[p])] = set.patches[p];
  for (geometry::Boundary& boundary : result.boundaries)
    for (geometry::PatchFace& face : boundary.faces) face.patch = place(face.patch);
  for (geometry::StatedInterface& stated : result.interfaces) {
    stated.first.patch = place(stated.first.patch);
    stated.second.patch = place(stated.second.patch);
  }
  return result;
}

std::vector<int> random_order(std::size_t count, unsigned seed) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(seed);
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

// What is done to a problem, and what must become of its energy.
struct Change {
  std::string what;
  Matrix3d rotation = Matrix3d::Identity();
  double length = 1;    // factor of all coordinates, such as 1000 from m to mm
  double stress = 1;    // factor of all stresses, such as 1e-6 from Pa to MPa
  double far = 0;       // model sizes to go from the origin
  unsigned order = 0;   // seed of another order of the patches; 0: as they are
  unsigned turned = 0;  // seed of other orientations; 0: as they are

  double energy() const { return stress * length * length * length; }
};

const std::vector<Change>& changes() {
  static const std::vector<Change> all = {{.what = "rotated", .rotation = oblique_rotation()},
                                          {.what = "in mm and MPa", .length = 1e3, .stress = 1e-6},
                                          {.what = "in km and GPa", .length = 1e-3, .stress = 1e-9},
                                          {.what = "10 sizes from the origin", .far = 10},
                                          {.what = "1000 sizes from the origin", .far = 1e3},
                                          {.what = "patches renumbered", .order = 5},
                                          {.what = "patches reoriented", .turned = 6},
                                          {.what = "all of these at once",
                                           .rotation = oblique_rotation(),
                                           .length = 1e3,
                                           .stress = 1e-6,
                                           .far = 1e3,
                                           .order = 7,
                                           .turned = 8}};
  return all;
}

// Held on one boundary, pulled at another, under its weight; every other patch, as first numbered, is softer.
iga::ElasticityProblem changed(const geometry::PatchSet& original, const std::string& held,
                               const std::string& loaded, const Change& change) {
  const double size = geometry::connect(original).size();
  geometry::PatchSet set = moved(original, {change.length * change.rotation,
                                            change.far * size * change.length * Vector3d(2, -1, 2) / 3});
  if (change.turned) set = geometry::randomly_reoriented(set, change.turned);
  std::vector<int> order(set.patches.size());
  std::iota(order.begin(), order.end(), 0);
  if (change.order) order = random_order(set.patches.size(), change.order);
  const geometry::MultiPatch model = geometry::connect(renumbered(set, order));
  iga::ElasticityProblem p{iga::discretize(model, {.degree = {2, 2, 2}, .refine = 1}),
                           std::vector<iga::Material>(order.size()),
                           {},
                           {},
                           {}};
  for (std::size_t i = 0; i < order.size(); ++i)
    p.materials[static_cast<std::size_t>(order[i])] =
        iga::isotropic(change.stress * (i % 2 == 0 ? 210e9 : 70e9), i % 2 == 0 ? 0.3 : 0.33);
  p.supports = {{"held", faces_of(model, held), iga::PrescribedDisplacement{}}};
  p.surface_loads = {iga::constant_traction("pull", faces_of(model, loaded),
                                            change.stress * (change.rotation * Vector3d(10e6, -2e6, 5e6)))};
  p.volume_loads = {{"weight", all_patches(model), [change, size](const Vector3d&) -> Vector3d {
                       return change.stress / change.length * (change.rotation * Vector3d(0, 1e6, -2e6)) /
                              size;
                     }}};
  return p;
}

void expect_same_energy(const std::string& name, const geometry::PatchSet& set, const std::string& held,
                        const std::string& loaded, iga::Coupling coupling) {
  const auto energy = [&](const Change& change) {
    return iga::solve_elasticity(changed(set, held, loaded, change), {.coupling = coupling})
               .results.internal_energy /
           change.energy();
  };
  const double as_it_is = energy({});
  for (const Change& change : changes())
    expect(Claim{fmt::format("{}, {}, {}: energy", name, iga::name(coupling), change.what),
                 "J",
                 ReferenceKind::exact,
                 "the same part as it is",
                 as_it_is,
                 energy(change),
                 allowed_change,
                 {}});
}

TEST(Invariance, Elimination) {
  for (const ModelCase& model : every_model_case())
    expect_same_energy(model.name, patches_of(model), model.held, model.loaded, iga::Coupling::elimination);
}

TEST(Invariance, Multipliers) {
  for (const char* name : {"link", "distorted box"}) {
    const ModelCase& model = model_case(name);
    expect_same_energy(name, patches_of(model), model.held, model.loaded, iga::Coupling::lagrange);
  }
}

// Where bending is weak beside stretching, the matrix itself says no more than round-off times its condition
// number about the energy: the classic membrane, 1 thick and some 50 wide, bent out of its plane.
TEST(Invariance, ThinMembrane) {
  const ModelCase thin = {
      "Cook's membrane, 1 thick", {"model.generate=cook", "model.patches=[2, 2]"}, "x_min", "x_max"};
  const geometry::PatchSet set = patches_of(thin);
  const auto energy = [&](const Change& change) {
    return iga::solve_elasticity(changed(set, thin.held, thin.loaded, change)).results.internal_energy /
           change.energy();
  };
  const Eigen::VectorXd eigenvalues = sorted_eigenvalues(
      dense(system_of(changed(set, thin.held, thin.loaded, {}), iga::Coupling::elimination)));
  const double condition = eigenvalues.tail<1>()[0] / eigenvalues[0];
  const double as_it_is = energy({});
  for (const Change& change : changes())
    expect(
        Claim{fmt::format("{}, {}: change of the energy by round-off times the condition number of {:.1e}",
                          thin.name, change.what, condition),
              "",
              ReferenceKind::exact,
              "the same part as it is",
              0.2,  // 0.04 has been seen
              std::abs(energy(change) / as_it_is - 1) / (std::numeric_limits<double>::epsilon() * condition),
              0,
              {},
              Comparison::at_most,
              0.});
}

// What a user can say in a study: another unit of length for the same numbers, another origin, other
// orientations.
void expect_study(const ModelCase& model, const std::string& what, const std::vector<std::string>& change,
                  double factor) {
  const std::string file = "verification/studies/pulled.toml";
  std::vector<std::string> overrides = pulled_overrides(model);
  overrides.emplace_back("load.1.gravity=[0, 0, 0]");
  const SolvedStudy as_it_is = solved(file, overrides);
  overrides.insert(overrides.end(), change.begin(), change.end());
  const SolvedStudy changed = solved(file, overrides);
  expect(Claim{fmt::format("{}, study {}: energy", model.name, what), "J", ReferenceKind::exact,
               "the same part as it is", factor * as_it_is.run.solution.results.internal_energy,
               changed.run.solution.results.internal_energy, allowed_change, changed.named});
}

TEST(Invariance, Studies) {
  expect_study(model_case("link"), "in mm instead of m", {"model.length_unit=mm"}, 1e-9);
  expect_study(model_case("link"), "in inches instead of m", {"model.length_unit=in"}, std::pow(0.0254, 3));
  expect_study(model_case("distorted box"), "1000 sizes from the origin", {"model.origin=[1155, -577, 1155]"},
               1);
  expect_study(model_case("distorted box"), "with other orientations", {"model.orientation_seed=12"}, 1);
}

TEST(FullInvariance, Terrific) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  geometry::PatchSet set = reference_patches("terrific/terrific.xml");
  set.boundaries = {{"clamped",
                     {{PatchId(0), geometry::Side::back},
                      {PatchId(1), geometry::Side::back},
                      {PatchId(2), geometry::Side::south}}},
                    {"loaded", {{PatchId(13), geometry::Side::front}, {PatchId(14), geometry::Side::north}}}};
  expect_same_energy("TERRIFIC", set, "clamped", "loaded", iga::Coupling::elimination);
}

}  // namespace
}  // namespace isopatch::verification
