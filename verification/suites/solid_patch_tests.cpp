// The patch test on volumes made of solids by the parameterization: a linear displacement is found exactly on
// each, so its patches fit together and are integrated rightly.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "geometry/base/tests/data_file.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/twisted_beam.hpp"
#include "iga/solve_elasticity.hpp"
#include "segmentation/parameterization/assemble_complex.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/linear_field.hpp"

namespace isopatch::verification {
namespace {

using geometry::Side;
using segmentation::DomainCurve;
using segmentation::HexSolid;

DomainCurve line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return [=](double t) -> Eigen::Vector2d { return (1 - t) * from + t * to; };
}
DomainCurve reversed(const DomainCurve& curve) {
  return [=](double t) { return curve(1 - t); };
}

segmentation::SolidFace face_on(Side side, const segmentation::DomainSurface& surface,
                                const std::array<DomainCurve, 4>& curves) {
  using segmentation::side_corner;
  return {
      std::string(geometry::name(side)),
      {side_corner(side, 0, 0), side_corner(side, 1, 0), side_corner(side, 1, 1), side_corner(side, 0, 1)},
      {curves.begin(), curves.end()},
      surface};
}

const std::array<DomainCurve, 4> unit_square = {line({0, 0}, {1, 0}), line({1, 0}, {1, 1}),
                                                line({1, 1}, {0, 1}), line({0, 1}, {0, 0})};

/// The solid that a volume fills, by its six faces.
HexSolid solid_of(const std::string& name, const geometry::NurbsVolume& volume) {
  HexSolid solid{name, {}, {}};
  const Eigen::Vector3d low = volume.low(), size = volume.high() - volume.low();
  for (int c = 0; c < 8; ++c)
    solid.vertices.push_back(
        volume.point(low + size.cwiseProduct(Eigen::Vector3d(c & 1, (c >> 1) & 1, (c >> 2) & 1))));
  for (const Side side : geometry::all_sides) {
    const geometry::NurbsSurface surface = face_surface(volume, side);
    const auto at = [surface](const Eigen::Vector2d& uv) -> Eigen::Vector3d {
      return surface.point(surface.low() + uv.cwiseProduct(surface.high() - surface.low()));
    };
    solid.faces.push_back(face_on(side, at, unit_square));
  }
  return solid;
}

/// A slab between two plane faces that are trimmed by an outline with a dent: not convex.
HexSolid dented_slab() {
  const DomainCurve dent = [](double s) -> Eigen::Vector2d {
    return {s, 0.3 * std::pow(std::sin(std::numbers::pi * s), 2)};
  };
  const std::array<DomainCurve, 4> outline = {dent, line({1, 0}, {1, 1}), line({1, 1}, {0, 1}),
                                              line({0, 1}, {0, 0})};
  constexpr double height = 0.4;
  HexSolid solid{"trimmed non-convex face", {}, {}};
  for (int c = 0; c < 8; ++c) solid.vertices.emplace_back(c & 1, (c >> 1) & 1, height * ((c >> 2) & 1));
  for (const Side side : {Side::front, Side::back}) {
    const double z = side == Side::back ? height : 0;
    solid.faces.push_back(face_on(
        side,
        [z](const Eigen::Vector2d& uv) -> Eigen::Vector3d {
          return {uv[0], uv[1], z};
        },
        outline));
  }
  const std::array<std::pair<Side, DomainCurve>, 4> walls = {{{Side::south, outline[0]},
                                                              {Side::east, outline[1]},
                                                              {Side::north, reversed(outline[2])},
                                                              {Side::west, reversed(outline[3])}}};
  for (const auto& [side, wall] : walls)
    solid.faces.push_back(face_on(
        side,
        [wall = wall](const Eigen::Vector2d& uv) -> Eigen::Vector3d {
          const Eigen::Vector2d p = wall(uv[0]);
          return {p[0], p[1], height * uv[1]};
        },
        unit_square));
  return solid;
}

/// The field held on the first boundary face and caused by tractions on all others.
iga::ElasticityProblem pulled(const LinearField& field, const geometry::MultiPatch& model) {
  const iga::Material material = iga::isotropic(1e9, 0.3);
  iga::ElasticityProblem p{
      iga::discretize(model, {}),
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

void expect_passes(const std::string& name, const segmentation::HexComplex& complex,
                   const std::vector<iga::Coupling>& couplings, const Tolerance& allowed) {
  const segmentation::Parameterization made = parameterize(complex);
  EXPECT_TRUE(made.report.usable()) << name << ": " << testing::PrintToString(made.report.complaints());
  const LinearField field = generic_linear_field();
  const iga::ElasticityProblem problem = pulled(field, geometry::connect(made.patches));
  for (const iga::Coupling coupling : couplings) {
    // Degree 3: products of two first derivatives of the map and one of a function have degree 8.
    iga::ElasticityOptions options{.coupling = coupling, .quadrature_points = 5};
    // A default tolerance of iterations would leave 2e-9.
    options.solver.method =
        coupling == iga::Coupling::elimination ? solvers::Method::cholmod : solvers::Method::mumps;
    const auto solution = iga::solve_elasticity(problem, options);
    expect(Claim{fmt::format("{}, {}: largest error of a coefficient of u", name, iga::name(coupling)), "",
                 ReferenceKind::exact, "linear field", 0, coefficient_error(solution.field, field), allowed});
  }
}

void expect_passes(const HexSolid& solid) {
  expect_passes(solid.name, segmentation::hex_complex({segmentation::hexahedron(solid)}),
                {iga::Coupling::elimination}, of_one_solid);
}

void expect_passes(const std::string& file) {
  const std::filesystem::path path = isopatch::test::data_file(file);
  ISOPATCH_NEEDS(path);
  segmentation::BlockFiles blocks;
  blocks.files = {path};
  expect_passes(path.filename().string(), segmentation::read_blocks(blocks).complex,
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
  expect_passes("chair stand", segmentation::read_blocks(blocks).complex,
                {iga::Coupling::elimination, iga::Coupling::lagrange},
                {5e-9, "the condition of fitted patches, worst with multipliers: 2e-9"});
}

}  // namespace
}  // namespace isopatch::verification
