// Supports and loads as parts have them: springs, pins, bodies that nothing holds; bearings, liquids, moments
// from afar, rotation, temperature. Every case in both couplings, and as several processes.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "verification/suites/several_processes.hpp"
#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

using Eigen::Vector3d;

const std::vector<std::string> held_couplings = {"elimination", "lagrange"};

// Where the solution lies in the space.
const Tolerance in_the_space = round_off(1e3, "a solve on distorted patches");

// What springs that stand for a hold enlarge round-off by.
const Tolerance of_stiff_springs = {1e-8,
                                    "by the condition of springs ten thousand times as stiff as the part"};

class HeldClaims {
 public:
  HeldClaims(const std::string& file, const std::string& coupling, std::string source,
             std::vector<std::string> overrides = {})
      : of_(", " + coupling),
        source_(std::move(source)),
        run_(solved_by(file, coupling, std::move(overrides))) {}
  const iga::ElasticityResults& results() const { return run_.run.solution.results; }
  const iga::FieldValues& at(const std::string& probe) const { return run_.probe(probe).values; }
  void operator()(const std::string& what, const char* unit, double reference, double value,
                  const Tolerance& allowed = in_the_space) const {
    expect(Claim{what + of_, unit, ReferenceKind::closed_form, source_, reference, value, allowed, run_.named,
                 reference == 0 ? Comparison::absolute : Comparison::relative});
  }
  // Forces and energies of everything together.
  void balance(const Tolerance& allowed = in_the_space) const {
    Vector3d sum = results().total_load;
    for (const iga::Reaction& reaction : results().reactions) sum += reaction.force;
    (*this)("loads and reactions together, of the loads", "", 0, sum.norm() / results().load_size, allowed);
    (*this)("energy of part and springs over the work of loads and temperatures", "", 1,
            (results().internal_energy + results().support_energy) /
                (results().external_work + results().thermal_work),
            allowed);
  }

 private:
  static SolvedStudy solved_by(const std::string& file, const std::string& coupling,
                               std::vector<std::string> overrides) {
    overrides.push_back(fmt::format("coupling.method='{}'", coupling));
    return solved("verification/studies/" + file + ".toml", overrides);
  }

  std::string of_;
  std::string source_;
  SolvedStudy run_;
};

TEST(HeldAndLoaded, BarBetweenSprings) {
  const double series = 1 / (1 / 700.0 + 1 / 1000.0);  // the left spring and the bar
  const double end = 50 / (series + 300);
  for (const std::string& coupling : held_couplings) {
    const HeldClaims claim("sprung_bar", coupling, "springs in series and side by side");
    claim("u at the end", "m", end, claim.at("end").displacement[0]);
    claim("reaction of the left springs", "N", -series * end, claim.results().reactions[0].force[0]);
    claim("reaction of the right springs", "N", -300 * end, claim.results().reactions[1].force[0]);
    claim.balance();
  }
}

TEST(HeldAndLoaded, RingOnAPin) {
  const double nu = 0.3, mu = 1000 / (2 * (1 + nu)), lambda = 2 * mu * nu / (1 - 2 * nu);
  const double c = -10 / (2 * (lambda + mu) + 2 * mu / 4);
  const Tolerance of_points = {5e-3, "the pin holds as many points as there are functions, not all: 2e-3"};
  const Tolerance of_springs = {3e-3,
                                "the pin's springs are ten thousand times as stiff as the ring, not rigid"};
  for (const std::string& coupling : held_couplings) {
    const HeldClaims claim("held_ring", coupling, "Lame, u_r = 0 inside");
    claim("u_r at the outer wall", "m", c * (2 - 0.5), claim.at("outer wall").displacement[0], of_points);
    claim("u_r at the pin, of that at the outer wall", "", 0,
          claim.at("pin").displacement[0] / claim.at("outer wall").displacement[0], of_springs);
    claim("work of the pressure", "J", -0.5 * 10 * c * 1.5 * 2 * std::numbers::pi * 2 * 0.5,
          claim.results().external_work, {2e-3, "both of these"});
    claim.balance(of_stiff_springs);
  }
}

TEST(HeldAndLoaded, RingThatRotates) {
  // A disc's closed form with E' = E / (1 - nu^2), nu' = nu / (1 - nu) is that in plane strain.
  const double nu = 0.3 / 0.7, young = 1000 / (1 - 0.09), load = 3 * 2 * 2;
  const double inner = load / 4 * ((3 + nu) * 4 + (1 - nu)), outer = load / 4 * ((1 - nu) * 4 + (3 + nu));
  for (const std::string& coupling : held_couplings) {
    const HeldClaims claim("spinning_ring", coupling, "Timoshenko, rotating disc");
    claim("u_r at the inner wall", "m", inner / young, claim.at("inner wall").displacement[0], 5e-6);
    claim("u_r at the outer wall", "m", 2 * outer / young, claim.at("outer wall").displacement[0], 3e-6);
    claim("s_tt at the inner wall", "Pa", inner, claim.at("inner wall").stress(1, 1), 1e-2);
    claim.balance();
  }
}

TEST(HeldAndLoaded, BoxThatFloats) {
  for (const std::string& coupling : held_couplings) {
    const HeldClaims claim("immersed_box", coupling, "stress is minus the liquid's pressure");
    claim("s_xx in the middle", "Pa", -2.5e4, claim.at("middle").stress(0, 0));
    claim("s_zz in the middle", "Pa", -2.5e4, claim.at("middle").stress(2, 2));
    claim("s_yy at the top", "Pa", -2e4, claim.at("top").stress(1, 1));
    claim("s_yz at the top, of the pressure", "", 0, claim.at("top").stress(1, 2) / 2e4);
    claim("reaction of what holds it, of the loads", "", 0,
          claim.results().reactions[0].force.norm() / claim.results().load_size);
    claim.balance();
  }
}

TEST(HeldAndLoaded, BoxThatIsWarmed) {
  for (const std::string& coupling : held_couplings) {
    const HeldClaims claim("heated_box", coupling, "a linear temperature causes no stress");
    // E alpha T is 500 Pa.
    claim("largest von Mises stress, of E alpha T", "", 0, claim.results().max_von_mises.value / 500);
    claim("largest principal stress, of E alpha T", "", 0, claim.results().peaks.tension.value / 500);
    claim("s_xx at an end, of E alpha T", "", 0, claim.at("far end").stress(0, 0) / 500);
    claim("lengthening of the lower edge", "m", 1e-5 * 40,
          claim.at("far end").displacement[0] - claim.at("near end").displacement[0], in_the_space);
    claim("strain at the end of the lower edge", "", 1e-5 * 40, claim.at("far end").strain(0, 0));
    const HeldClaims clamped(
        "heated_box", coupling, "-E alpha T / (1 - 2 nu)",
        {"support.0={name='all', faces=['x_min','x_max','y_min','y_max','z_min','z_max'], "
         "displacement=[0,0,0]}",
         "load.0.temperature={change=50}", "discretization.degree=1"});
    clamped("s_xx of the box held all around", "Pa", -1e6 * 1e-5 * 50 / 0.5,
            clamped.at("far end").stress(0, 0));
    clamped("largest compression of the box held all around", "Pa", 1e6 * 1e-5 * 50 / 0.5,
            clamped.results().peaks.compression.value);
    clamped("energy of the box held all around", "J", 0.5 * 1000 * 3 * 5e-4,
            clamped.results().internal_energy);
  }
}

TEST(HeldAndLoaded, BarBentFromAfar) {
  for (const std::string& coupling : held_couplings) {
    const HeldClaims claim("bent_bar", coupling, "M z / I");
    claim("s_xx above", "Pa", 18, claim.at("above").stress(0, 0));
    claim("s_xx below", "Pa", -18, claim.at("below").stress(0, 0));
    claim("energy", "J", 0.5 * 9 * 4 / (1000.0 / 12), claim.results().internal_energy);
    claim("reaction moment of the plane", "N m", -3, claim.results().reactions[0].moment[1]);
    // The same moment as a force beside the bar, whose own line of action is the bar's.
    const HeldClaims beside("bent_bar", coupling, "M z / I",
                            {"load.0.remote={force=[1,0,0], point=[9, 0.5, 3.5]}"});
    beside("s_xx above, by a force 3 m off the axis", "Pa", 19, beside.at("above").stress(0, 0));
    beside("s_xx below, by a force 3 m off the axis", "Pa", -17, beside.at("below").stress(0, 0));
    beside.balance();
  }
}

// A pin in the bore of the link: its pressure adds up, whatever holds the other one.
TEST(HeldAndLoaded, LinkOnTwoPins) {
  for (const std::string& coupling : held_couplings) {
    const HeldClaims claim("pinned_link", coupling, "equilibrium");
    claim("force of the pin", "N", 12000, claim.results().total_load[0]);
    claim("reaction of the other pin", "N", -12000, claim.results().reactions[0].force[0], of_stiff_springs);
    claim.balance(of_stiff_springs);
  }
}

// Holds by springs cost iterations, but no more on finer meshes.
TEST(HeldAndLoaded, LinkOnTwoPinsByIterations) {
  for (const int refine : {1, 2}) {
    const ClaimStudy study = {"verification/studies/pinned_link.toml",
                              {"solver.method='cg'", fmt::format("discretization.refine={}", refine)}};
    const SolvedStudy s = solved(study.file, study.overrides);
    expect(Claim{.what = fmt::format("iterations of cg, link on two pins, refine = {}", refine),
                 .kind = ReferenceKind::other_method,
                 .source = "some five times those of a clamped link",
                 .reference = 80,
                 .value = static_cast<double>(s.run.solution.solver.iterations),
                 .study = study,
                 .comparison = Comparison::at_most,
                 .least = 1});
  }
}

class HeldAndLoadedParallel : public SeveralProcesses {};

// Springs and points on several processes, also where patches are cut in layers.
TEST_F(HeldAndLoadedParallel, AreTheSame) {
  const std::vector<std::vector<std::string>> ways = {
      {"solver.method='mumps'"},
      {"solver.method='cg'", "solver.tolerance=1e-11"},
      {"coupling.method='lagrange'"},
      {"coupling.method='lagrange'", "solver.method='minres'", "solver.tolerance=1e-10"}};
  const Tolerance same = {1e-8, "iterations, and springs ten thousand times as stiff as the part"};
  for (const std::vector<std::string>& way : ways) {
    expect_same_energy("sprung_bar", way, same);
    expect_same_energy("pinned_link", way, same);
    expect_same_energy("bent_bar", way, same);
  }
}

}  // namespace
}  // namespace isopatch::verification
