// Benchmarks with published figures, as studies that a user could have written.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

TEST(Published, CookMembrane) {
  const SolvedStudy s = solved("verification/studies/cook.toml");
  expect(Claim{"u_y in the middle of the loaded edge", "m", ReferenceKind::published,
               "Cook's membrane, plane stress: 23.96", 23.967,
               s.probe("middle of the loaded edge").values.displacement[1], 2e-3, s.named});
  expect(Claim{"energy of the half", "J", ReferenceKind::independent_fe, "finite elements, refined",
               0.5 * 12.020, s.run.solution.results.internal_energy, 2e-3, s.named});
}

// Energies fall towards their limit like h^(2 alpha) at the re-entrant edge, so that three meshes give the
// limit.
double extrapolated(double coarse, double middle, double fine) {
  const double ratio = (middle - coarse) / (fine - middle);
  return fine + (fine - middle) / (ratio - 1);
}

TEST(Published, LBracket) {
  std::vector<double> energies;
  ClaimStudy finest;
  for (const int refine : {1, 2, 3}) {
    const SolvedStudy s =
        solved("verification/studies/bracket.toml", {fmt::format("discretization.refine={}", refine)});
    energies.push_back(s.run.solution.results.internal_energy);
    finest = s.named;
  }
  expect(Claim{"energy, extrapolated from three meshes", "J", ReferenceKind::independent_fe,
               "finite elements, extrapolated", 0.02386, extrapolated(energies[0], energies[1], energies[2]),
               2e-3, finest});
  expect(Claim{"energy with 8 cubic elements a leg", "J", ReferenceKind::independent_fe,
               "finite elements, extrapolated", 0.02386, energies[2], 1e-2, finest});
}

}  // namespace
}  // namespace isopatch::verification
