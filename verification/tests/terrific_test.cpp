// The TERRIFIC demonstrator at t = (20, -14, 0) MPa against published and independent figures.

#include <gtest/gtest.h>

#include "geometry/measures.hpp"
#include "iga/solve_elasticity.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

using geometry::PatchFace;
using geometry::Side;

const std::vector<PatchFace> clamped = {
    {PatchId(0), Side::back}, {PatchId(1), Side::back}, {PatchId(2), Side::south}};
const std::vector<PatchFace> loaded = {{PatchId(13), Side::front}, {PatchId(14), Side::north}};

iga::ElasticitySolution terrific(const iga::DiscretizationOptions& options, iga::Coupling coupling) {
  const geometry::MultiPatch model = geometry::connect(reference_patches("terrific/terrific.xml"));
  iga::ElasticityProblem problem{iga::discretize(model, options), {}, {}, {}, {}};
  problem.materials.assign(static_cast<std::size_t>(model.patch_count()),
                           iga::Material{54.0e9, 27.8e9, 0, "aluminium"});
  problem.supports = {{"clamped bore", clamped, iga::PrescribedDisplacement{}}};
  problem.surface_loads = {iga::constant_traction("loaded bore", loaded, {20e6, -14e6, 0})};
  return iga::solve_elasticity(problem, {.coupling = coupling});
}

double area(const geometry::MultiPatch& model, const std::vector<PatchFace>& faces) {
  double sum = 0;
  for (const PatchFace face : faces)
    sum += geometry::area(geometry::face_surface(model.patch(face.patch), face.side));
  return sum;
}

class Terrific : public ::testing::Test {
 protected:
  void SetUp() override { ISOPATCH_NEEDS_DATA("terrific/terrific.xml"); }
};

TEST_F(Terrific, HasTheVolumeAndAreasOfThePart) {
  const geometry::MultiPatch model = geometry::connect(reference_patches("terrific/terrific.xml"));
  double volume = 0;
  for (const auto& patch : model.patches()) volume += geometry::volume(patch);
  EXPECT_NEAR(volume, 4.65324e-4, 1e-9);
  EXPECT_NEAR(area(model, clamped), 2.2521e-3, 1e-7);
  EXPECT_NEAR(area(model, loaded), 2.25115e-3, 1e-8);
}

TEST_F(Terrific, HasTheEnergyOfAnotherIgaCodeAsItIs) {
  const auto solution = terrific({}, iga::Coupling::elimination);
  EXPECT_EQ(solution.size.dofs_uncoupled, 19422);
  EXPECT_EQ(solution.size.dofs_eliminated, 15804);
  EXPECT_EQ(solution.size.dofs_free, 14922);
  EXPECT_NEAR(solution.results.internal_energy / 68.5963, 1, 1e-4);
  EXPECT_NEAR(solution.results.max_displacement.value, 6.838e-3, 5e-6);
}

TEST_F(Terrific, HasTheEnergyOfAnotherIgaCodeRefinedOnce) {
  const auto solution = terrific({.refine = 1}, iga::Coupling::elimination);
  EXPECT_EQ(solution.size.dofs_free, 73746);
  EXPECT_NEAR(solution.results.internal_energy / 69.7972, 1, 1e-4);
  EXPECT_NEAR(solution.results.max_displacement.value, 6.961e-3, 5e-6);
}

TEST_F(Terrific, ConvergesToIndependentFiniteElementsAtDegreeThree) {
  const auto solution = terrific({.degree = {3, 3, 3}}, iga::Coupling::elimination);
  EXPECT_EQ(solution.size.control_points, 28960);
  EXPECT_GT(solution.results.internal_energy, 69.5);
  EXPECT_LT(solution.results.internal_energy, 70.6);
  EXPECT_GT(solution.results.max_displacement.value, 6.93e-3);
  EXPECT_LT(solution.results.max_displacement.value, 7.06e-3);
}

TEST_F(Terrific, GivesTheSameWithMultipliers) {
  const auto a = terrific({}, iga::Coupling::elimination);
  const auto b = terrific({}, iga::Coupling::lagrange);
  EXPECT_NEAR(a.results.internal_energy / b.results.internal_energy, 1, 1e-9);
  double apart = 0;
  for (std::size_t p = 0; p < a.field.displacement.size(); ++p)
    apart = std::max(apart, (a.field.displacement[p] - b.field.displacement[p]).colwise().norm().maxCoeff());
  EXPECT_LT(apart / a.results.max_displacement.value, 1e-9);
}

}  // namespace
}  // namespace isopatch::verification
