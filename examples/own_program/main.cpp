// A link with two eyes, clamped in the left bore, pulled by 10 kN on a part of the right one.
#include <cstdio>

#include "geometry/base/error.hpp"
#include "geometry/models/link.hpp"
#include "geometry/named_faces.hpp"
#include "iga/estimate/error_estimate.hpp"
#include "iga/solution/solve_elasticity.hpp"

using namespace isopatch;

int main() try {
  // Any source of patches will do: geometry::read_patches("part.xml") reads those of G+Smo and MFEM. SI
  // units.
  geometry::PatchSet link = geometry::link_model();
  for (geometry::NurbsVolume& patch : link.patches)
    patch = geometry::NurbsVolume(patch.knots(), 1e-3 * patch.control_points(), patch.weights());
  const geometry::MultiPatch model = geometry::connect(std::move(link));

  iga::ElasticityProblem problem{
      .discretization = iga::discretize(model, {.degree = {3, 3, 3}, .refine = 1}),
      .materials = std::vector(static_cast<std::size_t>(model.patch_count()), iga::isotropic(210e9, 0.3)),
      .supports = {{"clamp", geometry::named_faces(model, "bore_left"), iga::PrescribedDisplacement{}}},
      .surface_loads = {},
      .volume_loads = {}};
  // What of the bore lies beyond its axis, in elements or across them.
  problem.surface_loads = {iga::total_force("pin", geometry::named_faces(model, "bore_right"), {1e4, 0, 0},
                                            problem.discretization, iga::half_space({0.1, 0, 0}, {1, 0, 0}))};

  const iga::ElasticitySolution solution = iga::solve_elasticity(problem);
  const iga::ErrorEstimate error = iga::estimate_error(problem, solution.field);
  const iga::ElasticityResults& results = solution.results;
  std::printf("largest displacement   %.4g mm\n", 1e3 * results.max_displacement.value);
  std::printf("largest von Mises      %.4g MPa in patch %d\n", 1e-6 * results.max_von_mises.value,
              results.max_von_mises.patch);
  std::printf("energy                 %.4g J, discretization error %.2g %% in the energy norm\n",
              results.internal_energy, 100 * error.relative);
  std::printf("reaction of the clamp  %.6g N\n", results.reactions[0].force.x());
  return 0;
} catch (const Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
