// Benchmarks with published figures, as studies that a user could have written.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

TEST(Published, NafemsLe10) {
  const SolvedStudy s = solved("examples/le10/study.toml");
  const Eigen::Matrix3d& stress = s.probe("D").values.stress;
  expect(Claim{"s_yy at D", "Pa", ReferenceKind::published, "NAFEMS LE10", -5.38e6, stress(1, 1), 5e-3,
               s.named});
  // Refined finite elements give -5.360 from their Gauss points and -5.414 at the node.
  expect(Claim{"s_yy at D", "Pa", ReferenceKind::independent_fe, "finite elements, mean of two", -5.387e6,
               stress(1, 1), 5e-3, s.named});
  expect(Claim{"s_zz at D, under the pressure", "Pa", ReferenceKind::exact, "the load", -1e6, stress(2, 2),
               1e-2, s.named});
}

TEST(Published, NafemsLe1) {
  const SolvedStudy s = solved("verification/studies/le1.toml");
  expect(Claim{"s_yy at D, in the middle plane", "Pa", ReferenceKind::published, "NAFEMS LE1", 92.7e6,
               s.probe("D in the middle plane").values.stress(1, 1), 5e-3, s.named});
  expect(Claim{"s_yy at D, on the free face", "Pa", ReferenceKind::published, "NAFEMS LE1", 92.7e6,
               s.probe("D on the free face").values.stress(1, 1), 5e-3, s.named});
  expect(Claim{"energy of the half", "J", ReferenceKind::independent_fe, "finite elements, refined", 304.187,
               s.run.solution.results.internal_energy, 1e-5, s.named});
}

TEST(Published, CookMembrane) {
  const SolvedStudy s = solved("examples/cook/study.toml");
  const double deflection = s.probe("middle of the loaded edge").values.displacement[1];
  expect(Claim{"u_y in the middle of the loaded edge",
               "m",
               ReferenceKind::published,
               "Cook's membrane, plane stress",
               23.96,
               deflection,
               {5e-4, "finite elements, refined, differ from it by 3e-4"},
               s.named});
  expect(Claim{"u_y in the middle of the loaded edge", "m", ReferenceKind::independent_fe,
               "finite elements, refined", 23.967, deflection, 5e-4, s.named});
  expect(Claim{"energy of the half", "J", ReferenceKind::independent_fe, "finite elements, refined",
               0.5 * 12.020, s.run.solution.results.internal_energy, 5e-4, s.named});
}

TEST(Published, MacNealHarderCylinder) {
  for (const auto& [nu, displacement] : {std::pair(0.3, 4.5825e-3), std::pair(0.49, 5.0399e-3),
                                         std::pair(0.499, 5.0602e-3), std::pair(0.4999, 5.0623e-3)}) {
    const SolvedStudy s =
        solved("verification/studies/macneal_cylinder.toml", {fmt::format("material.0.poisson={}", nu)});
    expect(Claim{fmt::format("u_r at the inner wall, nu = {}", nu),
                 "m",
                 ReferenceKind::published,
                 "MacNeal and Harder",
                 displacement,
                 s.probe("inner wall").values.displacement[0],
                 {2e-5, "the last printed digit"},
                 s.named});
  }
}

TEST(Published, MacNealHarderTwistedBeam) {
  const auto tip = [](const std::string& force, int component) {
    const SolvedStudy s = solved("verification/studies/twisted_beam.toml", {"load.0.force=" + force});
    return std::pair(s.probe("tip").values.displacement[component], s.named);
  };
  const auto [in_plane, in] = tip("[0, 0, 1]", 2);
  const auto [out_of_plane, out] = tip("[0, 1, 0]", 1);
  // The published figures are those of beam theory.
  expect(Claim{"tip displacement, force in the tip's plane", "in", ReferenceKind::published,
               "MacNeal and Harder", 5.424e-3, in_plane, 5e-3, in});
  expect(Claim{"tip displacement, force out of the tip's plane", "in", ReferenceKind::published,
               "MacNeal and Harder", 1.754e-3, out_of_plane, 5e-3, out});
}

// Energies fall towards their limit like h^(2 alpha) at the re-entrant edge, so that three meshes give the
// limit.
double extrapolated(double coarse, double middle, double fine) {
  const double ratio = (middle - coarse) / (fine - middle);
  return fine + (fine - middle) / (ratio - 1);
}

TEST(Published, LBracket) {
  std::vector<double> energies;
  double sag = 0;
  ClaimStudy finest;
  for (const int refine : {1, 2, 3}) {
    const SolvedStudy s =
        solved("verification/studies/bracket.toml", {fmt::format("discretization.refine={}", refine)});
    energies.push_back(s.run.solution.results.internal_energy);
    sag = s.probe("loaded end").values.displacement[1];
    finest = s.named;
  }
  expect(Claim{"energy, extrapolated from three meshes", "J", ReferenceKind::independent_fe,
               "finite elements, extrapolated", 0.02386, extrapolated(energies[0], energies[1], energies[2]),
               2e-3, finest});
  expect(Claim{"energy with 8 cubic elements a leg", "J", ReferenceKind::independent_fe,
               "finite elements, extrapolated", 0.02386, energies[2], 1e-2, finest});
  // The reference has three digits.
  expect(Claim{"u_y at the loaded end with 8 cubic elements a leg", "m", ReferenceKind::independent_fe,
               "finite elements, extrapolated", -0.0480, sag, 1e-2, finest});
}

}  // namespace
}  // namespace isopatch::verification
