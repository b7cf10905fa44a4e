// A body that nothing holds has six motions without energy, no more and no fewer.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "iga/post/internal_forces.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/dense_systems.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/moved_patches.hpp"

namespace isopatch::verification {
namespace {

using geometry::MultiPatch;

iga::ElasticityProblem free_problem(const geometry::PatchSet& set,
                                    const iga::DiscretizationOptions& options) {
  const MultiPatch model = geometry::connect(set);
  return {iga::discretize(model, options),
          std::vector<iga::Material>(static_cast<std::size_t>(model.patch_count()), iga::isotropic(1e9, 0.3)),
          {},
          {},
          {}};
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& w) {
  return (Eigen::Matrix3d() << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0).finished();
}

// Coefficients of a linear field, all patches one after the other.
Eigen::Matrix3Xd coefficients(const iga::Discretization& d, const LinearField& field) {
  Eigen::Matrix3Xd u(3, d.node_count());
  for (std::size_t p = 0; p < d.patches.size(); ++p)
    u.middleCols(d.first_node[p], d.patches[p].size()) =
        (field.gradient * d.patches[p].control_points()).colwise() + field.shift;
  return u;
}

// Largest force that a rigid motion causes, relative to the largest that a strain of the same size causes.
double rigid_force(const iga::ElasticityProblem& problem) {
  const iga::Discretization& d = problem.discretization;
  const auto force = [&](const LinearField& field) {
    return iga::internal_forces(d, problem.materials, coefficients(d, field))
        .forces.cwiseAbs()
        .maxCoeff<Eigen::PropagateNaN>();
  };
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(k);
    largest = larger(largest, force({unit * d.model.size(), Eigen::Matrix3d::Zero()}));
    largest = larger(largest, force({Eigen::Vector3d::Zero(), cross_matrix(unit)}));
  }
  return largest / force({Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()});
}

TEST(PatchTests, RigidMotionsCauseNoForce) {
  for (const ModelCase& model : every_model_case())
    expect(Claim{model.name + ": largest force from translations and rotations",
                 "",
                 ReferenceKind::exact,
                 "no strain",
                 0,
                 rigid_force(free_problem(patches_of(model), {.degree = {3, 3, 3}, .refine = 1})),
                 round_off(10, "gradients that cancel in a sum"),
                 {}});
}

void expect_zero_modes(const std::string& name, const geometry::PatchSet& set, int bodies) {
  const iga::ElasticityProblem problem = free_problem(set, {});
  for (const iga::Coupling coupling : iga::all_couplings) {
    const Eigen::VectorXd values = sorted_eigenvalues(dense(system_of(problem, coupling)));
    const Eigen::VectorXd sizes = values.cwiseAbs() / std::abs(values.tail<1>()[0]);
    const std::string of = fmt::format("{}, {}: ", name, iga::name(coupling));
    expect(Claim{of + "eigenvalues that are 0, of a free part",
                 "",
                 ReferenceKind::exact,
                 bodies == 1 ? "3 translations, 3 rotations" : "3 translations, 3 rotations each",
                 6.0 * bodies,
                 static_cast<double>((sizes.array() < 1e-11).count()),
                 0,
                 {}});
    expect(Claim{of + "largest of these, relative to the largest of all",
                 "",
                 ReferenceKind::exact,
                 "0",
                 0,
                 sizes[6 * bodies - 1],
                 round_off(1, "the dense matrix and its eigenvalues"),
                 {}});
  }
}

TEST(PatchTests, SixZeroModesOfAFreeBody) {
  for (const ModelCase& model : every_model_case()) expect_zero_modes(model.name, patches_of(model), 1);
}

TEST(PatchTests, TwelveZeroModesOfTwoFreeBodies) {
  const geometry::PatchSet bracket = patches_of(model_case("bracket"));
  expect_zero_modes("two brackets", together(bracket, moved(bracket, {.shift = {3, 4, 5}})), 2);
  const geometry::PatchSet plate = patches_of(model_case("plate"));
  expect_zero_modes("two plates", together(plate, moved(plate, {0.5 * oblique_rotation(), {9, 9, 9}})), 2);
}

}  // namespace
}  // namespace isopatch::verification
