// Natural modes against closed forms: every copy of equal frequencies, the rigid motions of free bodies as
// such.

#include "iga/solution/natural_modes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "app/problem/build_problem.hpp"
#include "app/study/parse_study.hpp"
#include "geometry/base/larger.hpp"
#include "verification/claims/expect.hpp"

namespace isopatch::verification {
namespace {

using std::numbers::pi;

// The modes of a study, as `isopatch modes` finds them.
struct FoundModes {
  ClaimStudy study;
  iga::NaturalModes found;
  std::vector<double> frequencies;  // of those that are not rigid, Hz

  explicit FoundModes(const std::string& name, std::vector<std::string> overrides = {})
      : study{"verification/studies/" + name + ".toml", std::move(overrides)} {
    const auto path = std::filesystem::path(ISOPATCH_SOURCE_DIR) / study.file;
    const app::Study read = app::read_study(path, study.overrides);
    app::BuiltProblem built = app::build_problem(read);
    if (read.modes.is_free) built.problem.supports.clear();
    found = iga::natural_modes(built.problem, {.number = read.modes.number});
    for (const iga::NaturalMode& mode : found.modes)
      if (!mode.is_rigid) frequencies.push_back(mode.frequency);
  }

  void claim(const std::string& what, double reference, double value, const Tolerance& allowed,
             const char* source, const char* unit = "Hz") const {
    expect(Claim{what, unit, ReferenceKind::closed_form, source, reference, value, allowed, study});
  }
  // What holds for all of them.
  void claim_sound(const std::string& of, int rigid,
                   const Tolerance& converged = {1e-6, "what the iteration stops at"}) const {
    double residual = 0;
    for (const iga::NaturalMode& mode : found.modes) residual = isopatch::larger(residual, mode.residual);
    claim("rigid motions named, " + of, rigid, found.rigid_motions, 0, "six motions of a free body", "");
    claim("modes that are rigid, " + of, rigid,
          static_cast<double>(std::count_if(found.modes.begin(), found.modes.end(),
                                            [](const auto& mode) { return mode.is_rigid; })),
          0, "six motions of a free body", "");
    claim("largest residual, " + of, 0, residual, converged, "K x = lambda M x", "");
    claim("worst orthogonality, " + of, 0, found.worst_orthogonality, {1e-9, "round-off"}, "x.M y = 0", "");
  }
};

TEST(NaturalModes, OfAPlate) {
  const FoundModes plate("modes_plate");
  // omega h sqrt(rho / G), thickness 0.1; in the plane of the plate u = sin(pi y) alone.
  const std::vector<double> bending = {0.0932, 0.2226, 0.2226, 0.3421, 0.4171, 0.4171};
  const std::vector<std::size_t> places = {0, 1, 2, 5, 6, 7};
  const Tolerance last_digit = {6e-4, "the last of its four digits"};
  ASSERT_GE(plate.frequencies.size(), 8u);
  for (std::size_t i = 0; i < places.size(); ++i)
    plate.claim(fmt::format("bending mode {} of a plate, omega h sqrt(rho / G)", i + 1), bending[i],
                2 * pi * 0.1 * plate.frequencies[places[i]], last_digit, "Srinivas, Joga Rao, Rao 1970", "");
  for (const std::size_t i : {3, 4})
    plate.claim(fmt::format("mode {} of a plate, in its plane", i + 1), 0.5, plate.frequencies[i],
                {1e-7, "degree 4 on six elements"}, "u = sin(pi y)");
  plate.claim_sound("plate", 0);
}

TEST(NaturalModes, OfABeam) {
  // Euler and Bernoulli; shear and rotary inertia take off some (h / L)^2.
  const auto bending = [](double root) { return root * root / (2 * pi * 25) * std::sqrt(0.01 / 12); };
  const FoundModes clamped("modes_beam");
  const Tolerance slender = {1e-3, "shear and rotary inertia, which a thin beam has not: 3e-4"};
  clamped.claim("first mode of a clamped beam", bending(1.8751040687), clamped.frequencies[0], slender,
                "Euler, Bernoulli");
  const Tolerance copies = {1e-8,
                            "what the iteration stops at; some copies are equal to round-off by chance"};
  clamped.claim("its copy across", clamped.frequencies[0], clamped.frequencies[1], copies,
                "symmetry of a square");
  clamped.claim("copies of the second mode", clamped.frequencies[2], clamped.frequencies[3], copies,
                "symmetry of a square");
  clamped.claim_sound("clamped beam", 0);
  const FoundModes free("modes_beam", {"modes.free=true"});
  const Tolerance shorter = {3e-3, "shear and rotary inertia, of a mode that bends more: 2e-3"};
  free.claim("first mode of a free beam", bending(4.7300407449), free.frequencies[0], shorter,
             "Euler, Bernoulli");
  free.claim("its copy across, free", free.frequencies[0], free.frequencies[1], copies,
             "symmetry of a square");
  free.claim_sound("free beam", 6,
                   {1e-5, "round-off of a stiffness whose largest eigenvalue is 1e9 times the first mode's"});
}

TEST(NaturalModes, OfAFreeCube) {
  const FoundModes cube("modes_cube");
  // u_x = cos(pi x) sin(pi y), u_y = -sin(pi x) cos(pi y): f = c / (L sqrt(2)), once for each pair of axes.
  std::vector<double> from_lame = cube.frequencies;
  const double lame = 1 / std::sqrt(2.0);
  std::sort(from_lame.begin(), from_lame.end(),
            [&](double a, double b) { return std::abs(a - lame) < std::abs(b - lame); });
  for (std::size_t i = 0; i < 3; ++i)
    cube.claim(fmt::format("Lame mode {} of 3 of a free cube", i + 1), lame, from_lame[i],
               {1e-6, "degree 5 on two elements"}, "Lame 1852");
  cube.claim_sound("free cube", 6);
}

}  // namespace
}  // namespace isopatch::verification
