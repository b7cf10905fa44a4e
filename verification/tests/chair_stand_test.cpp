// Study P9: the nine plastic patches of the chair stand, against finite elements on the same geometry.

#include <gtest/gtest.h>

#include "iga/solve_elasticity.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

using geometry::Side;

TEST(ChairStand, HasTheEnergyAndSagOfFiniteElements) {
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  geometry::PatchSet set = reference_patches("chair_stand/chair_stand.xml");
  for (auto& patch : set.patches)  // one unit of the file is 225 mm
    patch = geometry::NurbsVolume(patch.knots(), 0.225 * patch.control_points(), patch.weights());
  const geometry::MultiPatch model = geometry::connect(set);
  for (const auto coupling : {iga::Coupling::elimination, iga::Coupling::lagrange}) {
    iga::ElasticityProblem problem{iga::discretize(model), {}, {}, {}, {}};
    problem.materials.assign(9, iga::Material{3.19e9, 0.899e9, 0, "P6"});
    problem.supports = {
        {"sector planes", {{PatchId(1), Side::front}, {PatchId(1), Side::back}}, iga::PlaneSupport{}},
        {"pin hole",
         {{PatchId(6), Side::front}, {PatchId(8), Side::south}},
         iga::PrescribedDisplacement{{std::nullopt, std::nullopt, 0.0}}}};
    problem.surface_loads = {
        iga::total_force("hub bore", {{PatchId(1), Side::north}}, {0, 0, -159.903}, problem.discretization)};
    const iga::ElasticitySolution solution = iga::solve_elasticity(problem, {.coupling = coupling});
    EXPECT_NEAR(solution.results.internal_energy / 25.409e-3, 1, 0.005);
    // A traction spread evenly works on the mean displacement of its face.
    EXPECT_NEAR(2 * solution.results.internal_energy / 159.903 / 0.31781e-3, 1, 0.005);
    EXPECT_NEAR(solution.results.reactions[1].force[2], 159.903, 1e-6);
  }
}

}  // namespace
}  // namespace isopatch::verification
