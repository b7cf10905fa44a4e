// Supports and loads on parts of faces, at points and along lines that are no edges of patches or elements.
// Every case in both couplings, and as several processes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <string>
#include <vector>

#include "verification/suites/several_processes.hpp"
#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

using Eigen::Vector3d;

const std::vector<std::string> both_couplings = {"elimination", "lagrange"};

SolvedStudy solved_part(const std::string& file, const std::string& coupling,
                        std::vector<std::string> overrides = {}) {
  overrides.push_back(fmt::format("coupling.method='{}'", coupling));
  return solved("verification/studies/" + file + ".toml", overrides);
}

void claim_vector(const std::string& what, const char* unit, const char* source, const Vector3d& reference,
                  const Vector3d& value, const Tolerance& allowed, const ClaimStudy& study) {
  const double size = reference.norm();
  expect(Claim{what + ", off by, of its size", "", ReferenceKind::closed_form, source, 0,
               (value - reference).norm() / size, allowed, study, Comparison::absolute});
  expect(Claim{what, unit, ReferenceKind::closed_form, source, size, value.norm(), allowed, study});
}

// Two parts that meet inside of an element are the whole face to the accuracy of their integration.
TEST(PartsOfFaces, TogetherAreTheWhole) {
  for (const std::string& coupling : both_couplings) {
    const SolvedStudy s = solved_part("pads", coupling);
    const auto claim = [&](const std::string& what, const char* unit, double reference, double value) {
      expect(Claim{what + ", " + coupling, unit, ReferenceKind::closed_form, "springs in series", reference,
                   value, round_off(1e3, "integrating over parts of elements and solving"), s.named});
    };
    claim("u at the end", "m", 50 / 700.0 + 50 / 200.0, s.probe("end").values.displacement[0]);
    claim("energy in the springs", "J", 0.5 * 50 * 50 / 700, s.run.solution.results.support_energy);
    const auto& reactions = s.run.solution.results.reactions;
    claim("reactions of both parts", "N", -50, reactions[0].force[0] + reactions[1].force[0]);
    // The line through y = 0.37 at half the height leans by 0.2: it divides the face at 0.37 + 0.2 z.
    claim("area of the lower part", "m^2", 0.37 + 0.1, s.run.built.supports[0].area);
    claim("reaction of the lower part", "N", -50 * 0.47 / 2, reactions[0].force[0]);
  }
}

TEST(PartsOfFaces, AddUpToTheirForces) {
  for (const std::string& coupling : both_couplings) {
    const SolvedStudy s = solved_part("pressed_block", coupling);
    const auto cases = app::cases_of(s.run);
    const double disc = 2 * std::numbers::pi * 0.09;
    struct Statics {
      std::string name;
      Vector3d force, moment;  // about the origin
    };
    const auto at = [](const Vector3d& place, const Vector3d& force) { return Vector3d(place.cross(force)); };
    const std::vector<Statics> all = {{"disc", {0, 0, -disc}, at({0.9, 0.45, 1}, {0, 0, -disc})},
                                      {"pad", {1, 2, -3}, at({0.4, 0.55, 1}, {1, 2, -3})},
                                      {"blade", {0, 0, -5}, at({0.95, 0.45, 1}, {0, 0, -5})},
                                      {"fingers", {0, 0, -4}, at({1.015, 0.59, 1}, {0, 0, -4})}};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const iga::ElasticityResults& results = cases[i].solution.results;
      // A region's rim is found to round-off; its corners leave up to 1e-8 of an element.
      claim_vector("reaction of the floor, " + all[i].name + ", " + coupling, "N", "statics", -all[i].force,
                   results.reactions[0].force, {1e-7, "what corners of a region leave of an element"},
                   s.named);
      claim_vector("moment of the floor, " + all[i].name + ", " + coupling, "N m", "statics", -all[i].moment,
                   results.reactions[0].moment, {1e-7, "what corners of a region leave of an element"},
                   s.named);
    }
    expect(Claim{"area of the disc, " + coupling, "m^2", ReferenceKind::closed_form, "pi r^2", disc / 2,
                 s.run.built.loads[0].area, 1e-8, s.named});
    expect(Claim{"area of the pad, " + coupling, "m^2", ReferenceKind::closed_form, "a rectangle", 0.2,
                 s.run.built.loads[1].area, 1e-7, s.named});
  }
}

// What a load at A does at B, a load at B does at A.
TEST(PartsOfFaces, PointLoadsAreReciprocal) {
  for (const std::string& coupling : both_couplings) {
    const auto moved = [&](const std::string& loaded, const std::string& seen) {
      const SolvedStudy s = solved_part(
          "pressed_block", coupling,
          {"load=[{points=[" + loaded + "], force=[1,2,3]}]", "probe=[{name='there', point=" + seen + "}]",
           "support.0.part={box={min=[0,0,-1],max=[1.3,1,1]}}"});
      return std::pair(s.probe("there").values.displacement.dot(Vector3d(1, 2, 3)), s.named);
    };
    const std::string a = "[0.33,0.41,1]", b = "[1.7,0.77,0.4]";
    const auto [at_b, study] = moved(a, b);
    expect(Claim{"work of a load at B on what one at A does, " + coupling, "J", ReferenceKind::other_method,
                 "Maxwell and Betti: the same the other way round", moved(b, a).first, at_b,
                 round_off(1e3, "two solves with one matrix"), study});
  }
}

// Where the beam is thin, what the lines leave at themselves is little beside the bending.
TEST(PartsOfFaces, LinesCarryABeam) {
  const double inertia = std::pow(0.4, 4) / 12, force = 1e-2, span = 8, young = 1000;
  const double bending = force * std::pow(span, 3) / (48 * young * inertia);
  const double shear = force * span / (4 * 5.0 / 6 * young / 2 * 0.16);
  for (const std::string& coupling : both_couplings) {
    const SolvedStudy s = solved_part("three_point_bending", coupling);
    const auto claim = [&](const std::string& what, const char* unit, double reference, double value,
                           const Tolerance& allowed) {
      expect(Claim{what + ", " + coupling, unit, ReferenceKind::closed_form, "Timoshenko's beam", reference,
                   value, allowed, s.named});
    };
    const Tolerance local = {5e-3, "the lines dent the beam, which its theory has not"};
    claim("deflection in the middle", "m", -bending - shear,
          s.probe("below the blade").values.displacement[2], local);
    claim("lift of the free end", "m", force * span * span / (16 * young * inertia),
          s.probe("right end").values.displacement[2], local);
    const auto& reactions = s.run.solution.results.reactions;
    claim("reaction of the left line", "N", force / 2, reactions[0].force[2],
          {1e-6, "springs stiff, not rigid"});
    claim("reaction of the right line", "N", force / 2, reactions[1].force[2],
          {1e-6, "springs stiff, not rigid"});
  }
}

// A part that is held ends inside of an element, on Greville points: the same as where a patch ends there,
// but for what elements can follow. Elsewhere the rim is met to half an element.
TEST(PartsOfFaces, AreHeldAsPatchesAre) {
  const auto held = [&](const std::string& coupling, std::vector<std::string> how) {
    how.insert(how.end(), {"load=[{faces=['z_max'], traction=[1,0,-1]}]", "probe=[]"});
    return solved_part("pressed_block", coupling, std::move(how));
  };
  const double reference = held("elimination", {"support.0.faces=['0:front']", "discretization.refine=4"})
                               .run.solution.results.external_work;
  for (const std::string& coupling : both_couplings) {
    const SolvedStudy part =
        held(coupling, {"support.0.part={plane={point=[1,0,0],normal='-x'}}", "model.patches=[1,1,1]",
                        "discretization.refine=0", "discretization.elements_per_direction=[17,9,9]"});
    expect(Claim{"energy of a block held on half of a face, " + coupling,
                 "J",
                 ReferenceKind::other_method,
                 "held on a patch's face, on elements half as large",
                 reference,
                 part.run.solution.results.external_work,
                 {6e-2, "elements that the rim crosses cannot be held in part"},
                 part.named});
  }
}

class PartsOfFacesParallel : public SeveralProcesses {};

TEST_F(PartsOfFacesParallel, AreTheSame) {
  const Tolerance same = {1e-8, "iterations, and springs stiffer than the part"};
  for (const std::vector<std::string>& way : std::vector<std::vector<std::string>>{
           {"solver.method='mumps'"},
           {"solver.method='cg'", "solver.tolerance=1e-10"},
           {"coupling.method='lagrange'"},
           {"coupling.method='lagrange'", "solver.method='minres'", "solver.tolerance=1e-10"}})
    for (const std::string file : {"pads", "three_point_bending"}) expect_same_energy(file, way, same);
}

}  // namespace
}  // namespace isopatch::verification
