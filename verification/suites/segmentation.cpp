// Solids that are cut into hexahedra, from their files to energies, against quadratic tetrahedra on the
// solids themselves: the figures of segmentation.json, which scripts/segmentation_references makes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/base/tests/data_file.hpp"
#include "geometry/brep/read_brep.hpp"
#include "verification/suites/solved_study.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

using nlohmann::json;

/// Models without a folder are among the suite's studies, those in parts/ are drawn by verification/parts,
/// others are among the data by others.
bool is_own(const std::string& model) {
  return !std::filesystem::path(model).has_parent_path();
}

bool is_part(const std::string& model) {
  return model.starts_with("parts/");
}

std::filesystem::path path_of(const std::string& model) {
  if (is_own(model)) return std::filesystem::path(ISOPATCH_SOURCE_DIR) / "verification/studies" / model;
  return is_part(model) ? std::filesystem::path(ISOPATCH_PARTS) / std::filesystem::path(model).filename()
                        : test::data_file(model);
}

/// The model as a study in verification/studies names it.
std::string named_by_study(const std::string& model) {
  if (is_part(model)) return path_of(model).string();
  return is_own(model) ? model : "${ISOPATCH_DATA:-../../../shared/data}/" + model;
}

json segmentation_case(const std::string& model) {
  std::ifstream file(std::filesystem::path(ISOPATCH_SOURCE_DIR) / "verification/suites/segmentation.json");
  const json content = json::parse(file);
  for (const json& one : content["cases"])
    if (one["model"] == model) return one;
  throw std::out_of_range("no case " + model);
}

/// Of three meshes, each halved, at size 0. Energies of solids with clamped and concave edges converge with
/// order 1 to 2 at last; outside of that the meshes are too coarse to show their order, and the nearer bound
/// is taken.
double at_size_zero(const std::vector<double>& energies) {
  const double coarse = energies[0], middle = energies[1], fine = energies[2];
  const double ratio = std::clamp((middle - coarse) / (fine - middle), 2.0, 4.0);
  return fine + (fine - middle) / (ratio - 1);
}

/// Of the reference: its finest mesh and what three extrapolate to differ by as much.
double uncertainty(const json& one) {
  return 1 - one["meshes"][2]["energy"].get<double>() / one["energy"].get<double>();
}

SolvedStudy solved_case(const json& one, int refine) {
  const std::string model = one["model"];
  const auto faces = [&](const char* key) { return json::array({one[key]}).dump(); };
  return solved("verification/studies/segmented.toml",
                {"model.file=" + named_by_study(model), "support.0.faces=" + faces("held"),
                 "load.0.faces=" + faces("loaded"), fmt::format("discretization.refine={}", refine)});
}

/// @param from  refinement of the coarsest of three meshes
void expect_segmented(const std::string& model, int from) {
  const json one = segmentation_case(model);
  std::vector<double> energies;
  ClaimStudy finest;
  double volume = 0;
  for (int refine = from; refine < from + 3; ++refine) {
    const SolvedStudy study = solved_case(one, refine);
    energies.push_back(study.run.solution.results.internal_energy);
    volume = study.run.built.report.volume;
    finest = study.named;
  }
  expect(Claim{model + ": volume of the patches",
               "m^3",
               ReferenceKind::exact,
               "the solid's, over its faces",
               geometry::read_brep(path_of(model)).brep.volume(),
               volume,
               {1e-9, "sides are planes and cylinders, which patches have exactly: round-off"},
               finest});
  expect(Claim{
      fmt::format("{}: energy, extrapolated from refinements {} to {}", model, from, from + 2),
      "J",
      ReferenceKind::independent_fe,
      fmt::format("CalculiX, quadratic tetrahedra, three meshes of up to {} nodes, extrapolated by {:.1f} %",
                  one["meshes"][2]["nodes"].get<int>(), 100 * uncertainty(one)),
      one["energy"],
      at_size_zero(energies),
      {1e-2, "extrapolation, on both sides, of what converges slowly at clamped and concave edges"},
      finest});
}

TEST(Segmentation, OwnSolids) {
  for (const char* model : {"l_shape.off", "house.off", "steps.off"}) expect_segmented(model, 0);
}

/// A part, and the refinement of the coarsest of its three meshes.
struct Part {
  const char* model;
  int from;
};
/// Those of segmentation.json that become hexahedra so far; the fewer these are, the finer they have to be.
constexpr std::array parts_that_are_cut = {Part{"parts/chamfered_block.step", 0},
                                           Part{"parts/bored_block.step", 2},
                                           Part{"parts/link.step", 1},
                                           Part{"parts/bracket.step", 0},
                                           Part{"parts/flange.step", 0},
                                           Part{"parts/nut.step", 1},
                                           Part{"parts/cam.step", 1},
                                           Part{"parts/countersunk_plate.step", 1},
                                           Part{"parts/plate_with_2_bores.step", 1},
                                           Part{"parts/lever.step", 1},
                                           Part{"parts/gusset_bracket.step", 1},
                                           Part{"parts/bent_pipe.step", 1},
                                           Part{"parts/bent_bar.step", 0},
                                           Part{"parts/car_part.step", 0},
                                           Part{"parts/round_bar.step", 1},
                                           Part{"parts/stepped_shaft.step", 0},
                                           Part{"parts/bearing_block.step", 0}};

TEST(FullSegmentation, Parts) {
  for (const Part& part : parts_that_are_cut) expect_segmented(part.model, part.from);
}

// The TERRIFIC demonstrator as one CAD solid, 0.13 % larger than the published patches, against what these
// give.
TEST(FullSegmentation, DemonstratorFromCad) {
  const SolvedStudy study = solved("examples/parts/demonstrator.toml",
                                   {"model.file=" + path_of("parts/demonstrator.step").string()});
  const auto& results = study.run.solution.results;
  const Tolerance near{1e-2, "other pockets' corners, and 0.13 % more material"};
  expect(Claim{"demonstrator from CAD: largest displacement", "m", ReferenceKind::other_method,
               "the 15 published patches of examples/terrific, degree 3", 6.986e-3,
               results.max_displacement.value, near, study.named});
  expect(Claim{"demonstrator from CAD: energy", "J", ReferenceKind::other_method,
               "the 15 published patches of examples/terrific, degree 3", 70.025, results.internal_energy,
               near, study.named});
  expect(
      Claim{"demonstrator from CAD: energy on the same solid",
            "J",
            ReferenceKind::independent_fe,
            "CalculiX, quadratic tetrahedra of 8, 5.33 and 3.56 mm, 249,276 unknowns, extrapolated by 0.03 %",
            70.5341,
            results.internal_energy,
            {1e-2, "patches of one element, no refinement: 0.7 % too stiff"},
            study.named});
}

/// A study of the chair stand as solids from its dimensions, 0.4 % larger than the published patches, against
/// finite elements on those.
void expect_chair_stand(const std::string& study_name, const std::string& part, double energy, double sag,
                        double leg) {
  const SolvedStudy study = solved("examples/chair_stand_cad/" + study_name + ".toml",
                                   {"model.file=" + path_of("parts/" + part + ".step").string()});
  const auto& results = study.run.solution.results;
  const auto claim = [&](const std::string& what, const char* unit, double reference, double value,
                         const Tolerance& allowed) {
    expect(Claim{part + ", " + what, unit, ReferenceKind::independent_fe,
                 "quadratic bricks on the published patches", reference, value, allowed, study.named});
  };
  const Tolerance near{1.5e-2, "slot and sides go through some of the published ones' points"};
  claim("energy", "J", energy, results.internal_energy, near);
  claim("largest displacement against the lowest u_z", "m", sag, results.max_displacement.value, near);
  for (const char* side : {"left leg", "right leg"})
    claim(std::string("von Mises stress in the ") + side, "Pa", leg, study.probe(side).values.von_mises,
          {3e-2, "likewise, and a peak sampled in the finite elements' Gauss points"});
}

TEST(FullSegmentation, ChairStandFromCad) {
  expect_chair_stand("plastic", "chair_stand", 25.409e-3, 0.31872e-3, 1.426e6);
}

// Blocks of stand and pin do not match: Nitsche's method.
TEST(FullSegmentation, ChairStandWithRingAndPinFromCad) {
  expect_chair_stand("study", "chair_stand_with_ring_and_pin", 18.568e-3, 0.23548e-3, 1.482e6);
}

/// The patches of a part, volume alone.
void expect_volume(const std::string& part, const std::string& held, const std::string& loaded,
                   const std::string& reference, double volume,
                   const Tolerance& allowed = round_off(100, "turned faces are rational patches")) {
  const SolvedStudy study = solved(
      "verification/studies/segmented.toml",
      {"model.file=" + path_of("parts/" + part + ".step").string(), "support.0.faces=[\"" + held + "\"]",
       "load.0.faces=[\"" + loaded + "\"]", "discretization.refine=0"});
  expect(Claim{part + ": volume of the patches", "m^3", ReferenceKind::closed_form, reference, volume,
               study.run.built.report.volume, allowed, study.named});
}

TEST(Segmentation, TurnedPartsAreExact) {
  constexpr double pi = std::numbers::pi;
  expect_volume("bent_pipe", "lower end", "upper end", "Pappus: pi (25^2 - 20^2) mm^2 times 30 pi mm",
                225 * pi * 30 * pi * 1e-9);
  expect_volume("bent_bar", "lower end", "upper end", "Pappus: pi 10^2 mm^2 times 80 pi / 3 mm",
                100 * pi * 80 * pi / 3 * 1e-9);
}

/// Of a boss of radius r and height h from the axis of a bar of radius R on, outside of the bar: the integral
/// over its disc of h - sqrt(R^2 - y^2), by the trapezoidal rule in the angle of y = r sin(angle), which is
/// exact to round-off.
double boss_outside(double r, double h, double bar) {
  constexpr int steps = 256;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2 * std::numbers::pi * i / steps, y = r * std::sin(angle), x = r * std::cos(angle);
    sum += std::numbers::pi / steps * 2 * x * x * (h - std::sqrt(bar * bar - y * y));
  }
  return sum;
}

TEST(Segmentation, BranchedParts) {
  constexpr double pi = std::numbers::pi;
  // Half profile: plate, hub and what the fillet adds, a square less a quarter of a disc of 5 about (45, 21).
  const double fillet = 25 * 42.5 - (45 * 25 * pi / 4 - 125 / 3.0);
  const double profile = 16 * (80 * 80 - 25 * 25) / 2.0 + 44 * (40 * 40 - 25 * 25) / 2.0 + fillet;
  expect_volume("flange", "base", "hub", "Pappus, less eight bores of 14 mm",
                (2 * pi * profile - 8 * 16 * 49 * pi) * 1e-9);
  expect_volume("shaft_with_boss", "left end", "boss",
                "a bar, and the integral over the boss' disc outside of it",
                (pi * 400 * 120 + boss_outside(10, 40, 20)) * 1e-9,
                {1e-5, "where cylinders cross patches follow the edge to 1e-4 of the part's size"});
}

// a = 10 mm, b = 20 mm, p = 1 MPa, E = 1000 MPa, nu = 0.3: as in ClosedForms.HollowSphere, from a CAD file.
TEST(Segmentation, HollowBall) {
  const double wall = 0.01 / (1000 * 7) * ((1 - 0.6) + 1.3 * 8 / 2);
  const SolvedStudy s = solved("verification/studies/shell_octant.toml",
                               {"model.file=" + path_of("parts/shell_octant.step").string()});
  const auto claim = [&](const std::string& what, const char* unit, double reference, double value,
                         const Tolerance& allowed) {
    expect(Claim{"hollow ball: " + what, unit, ReferenceKind::closed_form, "Lame", reference, value, allowed,
                 s.named});
  };
  claim("u_r at the inner wall", "m", wall, s.probe("inner wall").values.displacement[0], 1e-4);
  claim("energy", "J", 0.5 * 1e6 * wall * std::numbers::pi / 2 * 1e-4, s.run.solution.results.internal_energy,
        1e-4);
}

TEST(Segmentation, House) {
  ISOPATCH_NEEDS_DATA("solids/house.off");
  expect_segmented("solids/house.off", 0);
}

TEST(FullSegmentation, TriangulatedE) {
  ISOPATCH_NEEDS_DATA("solids/E_triangulated.off");
  expect_segmented("solids/E_triangulated.off", 0);
}

TEST(Segmentation, CutLShape) {
  ISOPATCH_NEEDS_DATA("solids/ffoLshapeCut.xml");
  expect_segmented("solids/ffoLshapeCut.xml", 0);
}

TEST(Segmentation, Bipyramid) {
  ISOPATCH_NEEDS_DATA("solids/ffoTriBiPyramid.xml");
  expect_segmented("solids/ffoTriBiPyramid.xml", 0);
}

TEST(FullSegmentation, DoublePyramid) {
  ISOPATCH_NEEDS_DATA("solids/ffoTriDoublePyramid.xml");
  expect_segmented("solids/ffoTriDoublePyramid.xml", 1);  // its concave edges show their order later
}

TEST(Segmentation, RoundedBlock) {
  ISOPATCH_NEEDS_DATA("models/block_fillet1.step");
  expect_segmented("models/block_fillet1.step", 0);
}

// Few hexahedra, or one, have to be finer.
TEST(FullSegmentation, Cube) {
  ISOPATCH_NEEDS_DATA("solids/ffoCube_autoSurf.xml");
  expect_segmented("solids/ffoCube_autoSurf.xml", 2);
}

TEST(FullSegmentation, Block) {
  ISOPATCH_NEEDS_DATA("models/block.step");
  expect_segmented("models/block.step", 2);
}

TEST(FullSegmentation, Wedge) {
  ISOPATCH_NEEDS_DATA("models/wedge_ok.step");
  expect_segmented("models/wedge_ok.step", 2);
}

TEST(FullSegmentation, BlockWithHole) {
  ISOPATCH_NEEDS_DATA("models/block_through_hole.step");
  expect_segmented("models/block_through_hole.step", 2);
}

TEST(FullSegmentation, Cylinder) {
  ISOPATCH_NEEDS_DATA("models/cylinder.step");
  expect_segmented("models/cylinder.step", 1);
}

TEST(FullSegmentation, HalfVase) {
  ISOPATCH_NEEDS_DATA("solids/ffoVaseHalfed.xml");
  expect_segmented("solids/ffoVaseHalfed.xml", 1);
}

TEST(FullSegmentation, BlockWithRoundedEdges) {
  ISOPATCH_NEEDS_DATA("models/block_torus_fillet3.step");
  expect_segmented("models/block_torus_fillet3.step", 0);
}

TEST(FullSegmentation, ScrewThread) {
  ISOPATCH_NEEDS_DATA("models/cuboid_screw_thread.step");
  expect_segmented("models/cuboid_screw_thread.step", 0);
}

TEST(FullSegmentation, ThreeConcaveEdges) {
  ISOPATCH_NEEDS_DATA("models/three_concave_edge.step");
  expect_segmented("models/three_concave_edge.step", 0);
}

TEST(FullSegmentation, SevenConnected) {
  ISOPATCH_NEEDS_DATA("models/7-connected.step");
  expect_segmented("models/7-connected.step", 0);
}

TEST(FullSegmentation, ConjoinedTwins) {
  ISOPATCH_NEEDS_DATA("models/conjoined_twins.step");
  expect_segmented("models/conjoined_twins.step", 0);
}

TEST(FullSegmentation, SciencePark) {
  ISOPATCH_NEEDS_DATA("solids/ffoSciencePark2.xml");
  expect_segmented("solids/ffoSciencePark2.xml", 0);
}

}  // namespace
}  // namespace isopatch::verification
