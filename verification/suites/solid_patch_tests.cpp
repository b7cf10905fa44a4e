// The patch test on volumes made of solids by the parameterization: a linear displacement is found exactly on
// each, so its patches fit together and are integrated rightly.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/base/tests/data_file.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/twisted_beam.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/linear_field.hpp"

namespace isopatch::verification {
namespace {

using geometry::KnotVector;
using geometry::NurbsCurve;
using geometry::NurbsSurface;
using geometry::TrimmedSurface;

NurbsCurve domain_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 2);
  points.topRows<2>() << from, to;
  return {{KnotVector()}, points};
}

TrimmedSurface untrimmed(const NurbsSurface& surface) {
  const Eigen::Vector2d a = surface.low(), c = surface.high(), b(c[0], a[1]), d(a[0], c[1]);
  return {"", surface, {{domain_line(a, b), domain_line(b, c), domain_line(c, d), domain_line(d, a)}}};
}

/// The solid that a volume fills, by its six faces.
geometry::BrepFile solid_of(const std::string& name, const geometry::NurbsVolume& volume) {
  std::vector<TrimmedSurface> faces;
  for (const geometry::Side side : geometry::all_sides)
    faces.push_back(untrimmed(face_surface(volume, side)));
  return {geometry::sew(faces).brep, name};
}

/// A slab between two plane faces that are trimmed by an outline with a dent: not convex.
geometry::BrepFile dented_slab() {
  const Eigen::Vector3d up(0, 0, 0.4);
  const KnotVector knots = KnotVector::uniform(3, 8);
  const std::vector<double> greville = knots.greville();
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, knots.size());
  for (int i = 0; i < knots.size(); ++i) {
    const double s = greville[static_cast<std::size_t>(i)];
    points.col(i) << s, 0.3 * std::pow(std::sin(std::numbers::pi * s), 2), 0;
  }
  const std::vector<NurbsCurve> outline = {NurbsCurve({knots}, points), domain_line({1, 0}, {1, 1}),
                                           domain_line({1, 1}, {0, 1}), domain_line({0, 1}, {0, 0})};
  std::vector<TrimmedSurface> faces;
  for (const double share : {0.0, 1.0}) {
    Eigen::Matrix3Xd square(3, 4);
    square << 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0;
    faces.push_back(
        {"", NurbsSurface({KnotVector(), KnotVector()}, square.colwise() + share * up), {outline}});
  }
  for (const NurbsCurve& curve : outline) {
    Eigen::Matrix3Xd wall(3, 2 * curve.size());
    wall << curve.control_points(), curve.control_points().colwise() + up;
    faces.push_back(untrimmed(NurbsSurface({curve.knots(0), KnotVector()}, wall)));
  }
  return {geometry::sew(faces).brep, "trimmed non-convex face"};
}

/// The field held on the first boundary face and caused by tractions on all others.
iga::ElasticityProblem pulled(const LinearField& field, const geometry::MultiPatch& model, int refine) {
  const iga::Material material = iga::isotropic(1e9, 0.3);
  iga::ElasticityProblem p{
      iga::discretize(model, {.refine = refine}),
      std::vector<iga::Material>(static_cast<std::size_t>(model.patch_count()), material),
      {},
      {},
      {}};
  std::vector<geometry::PatchFace> faces = model.boundary_faces();
  p.supports = {{"held", {faces.front()}, field.prescribed()}};
  faces.erase(faces.begin());
  p.surface_loads = {{"stress", faces,
                      [stress = field.stress(material)](const Eigen::Vector3d&, const Eigen::Vector3d& n)
                          -> Eigen::Vector3d { return stress * n; }}};
  return p;
}

const Tolerance of_one_solid = round_off(300, "fitting, assembling and solving");

void expect_passes(const std::string& name, const segmentation::HexModel& hexahedra,
                   const std::vector<iga::Coupling>& couplings, const Tolerance& allowed) {
  const segmentation::Parameterization made = parameterize(hexahedra);
  EXPECT_TRUE(made.report.usable()) << name << ": " << testing::PrintToString(made.report.complaints());
  const LinearField field = generic_linear_field();
  const std::vector<geometry::NurbsVolume>& patches = made.patches.patches;
  const bool rational =
      std::any_of(patches.begin(), patches.end(), [](const auto& p) { return p.is_rational(); });
  // A quarter of a circle needs two elements and ten points for integrals to round-off: one element leaves
  // 7e-9, five points 5e-7.
  const iga::ElasticityProblem problem = pulled(field, geometry::connect(made.patches), rational ? 1 : 0);
  for (const iga::Coupling coupling : couplings) {
    // Degree 3: products of two first derivatives of the map and one of a function have degree 8.
    iga::ElasticityOptions options{.coupling = coupling, .quadrature_points = rational ? 10 : 5};
    // A default tolerance of iterations would leave 2e-9.
    options.solver.method =
        coupling == iga::Coupling::elimination ? solvers::Method::cholmod : solvers::Method::mumps;
    const auto solution = iga::solve_elasticity(problem, options);
    expect(Claim{fmt::format("{}, {}: largest error of a coefficient of u", name, iga::name(coupling)), "",
                 ReferenceKind::exact, "linear field", 0, coefficient_error(solution.field, field), allowed});
  }
}

void expect_passes(const geometry::BrepFile& solid) {
  expect_passes(solid.name, segmentation::hex_model({solid}), {iga::Coupling::elimination}, of_one_solid);
}

void expect_passes(const std::string& file) {
  const std::filesystem::path path = isopatch::test::data_file(file);
  ISOPATCH_NEEDS(path);
  segmentation::BlockFiles blocks;
  blocks.files = {path};
  expect_passes(path.filename().string(), segmentation::read_blocks(blocks).model,
                {iga::Coupling::elimination}, of_one_solid);
}

TEST(PatchTests, BlockOfAStepFile) {
  expect_passes("models/block.step");
}

TEST(PatchTests, WedgeOfAStepFile) {
  expect_passes("models/wedge_ok.step");
}

TEST(PatchTests, CubeOfTrimmedSurfaces) {
  expect_passes("solids/ffoCube.xml");
  expect_passes("solids/ffoCube_autoSurf.xml");
}

TEST(PatchTests, QuarterTubeAsASolid) {
  expect_passes(solid_of("quarter tube", geometry::cylinder_model({}).patches[0]));
}

TEST(PatchTests, TwistedBarAsASolid) {
  expect_passes(solid_of("twisted bar",
                         geometry::twisted_beam_model({.length = 4, .width = 1, .depth = 1}).patches[0]));
}

TEST(PatchTests, DoublyCurvedFacesOfASolid) {
  expect_passes(
      solid_of("doubly curved faces",
               geometry::box_model({.curvature = 0.4, .distort_faces = true, .seed = 3}).patches[0]));
}

TEST(PatchTests, TrimmedNonConvexFaceOfASolid) {
  expect_passes(dented_slab());
}

TEST(PatchTests, ChairStandOfNineSolids) {
  const std::filesystem::path folder = isopatch::test::data_file("chair_stand/solids");
  ISOPATCH_NEEDS(folder);
  segmentation::BlockFiles blocks;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".xml") blocks.files.push_back(entry.path());
  std::sort(blocks.files.begin(), blocks.files.end());
  blocks.length_unit = 0.225;
  expect_passes("chair stand", segmentation::read_blocks(blocks).model,
                {iga::Coupling::elimination, iga::Coupling::lagrange},
                {5e-9, "the condition of fitted patches, worst with multipliers: 2e-9"});
}

}  // namespace
}  // namespace isopatch::verification
