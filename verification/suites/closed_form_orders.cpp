// Problems whose solution is a formula but whose loads a study cannot say: orders of convergence, and figures
// where stress concentrates.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/brep/make_brep.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/plate.hpp"
#include "geometry/models/sphere.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "verification/suites/classic_fields.hpp"
#include "verification/suites/known_problem.hpp"
#include "verification/suites/known_problems.hpp"
#include "verification/suites/model_cases.hpp"

namespace isopatch::verification {
namespace {

using Eigen::Vector3d;
using geometry::MultiPatch;
using iga::Coupling;

void add_planes(iga::ElasticityProblem& problem, const std::vector<std::string>& planes) {
  for (const std::string& plane : planes)
    problem.supports.push_back({plane, faces_of(problem.discretization.model, plane), iga::PlaneSupport{}});
}

}  // namespace

// Lame's cylinder, a = 1, b = 2, p = 10, E = 1000, nu = 0.3. Around and along the axis the solution lies in
// the space; one element goes around, whose rational maps 8 points integrate below the finest error.
KnownProblem pressed_tube() {
  const iga::Material material = iga::isotropic(1000, 0.3);
  const MultiPatch model =
      geometry::connect(geometry::cylinder_model({.radial_patches = 2, .patches_around = 2}));
  return {"thick cylinder",
          ReferenceKind::closed_form,
          "Lame",
          pressed_cylinder(material, 10, 1, 2),
          [=](int degree, int elements) {
            iga::ElasticityProblem p = unloaded(
                model, {.degree = {degree, 2, 1}, .elements_per_direction = {elements, 0, 0}}, material);
            add_planes(p, {"start", "end", "bottom", "top"});
            p.surface_loads = {iga::pressure_load("pressure", faces_of(model, "inner"), 10)};
            return p;
          },
          8};
}

namespace {

/// The solid that a patch fills, its faces called as the model's boundaries are.
geometry::BrepFile tube_part(const MultiPatch& model, PatchId patch) {
  std::vector<geometry::TrimmedSurface> faces;
  for (const geometry::Side side : geometry::all_sides) {
    const geometry::NurbsSurface surface = face_surface(model.patch(patch), side);
    const Eigen::Vector2d a = surface.low(), c = surface.high();
    const auto line = [](double u, double v, double to_u, double to_v) {
      return geometry::segment({u, v, 0}, {to_u, to_v, 0});
    };
    geometry::TrimmedSurface face{"",
                                  surface,
                                  {{line(a[0], a[1], c[0], a[1]), line(c[0], a[1], c[0], c[1]),
                                    line(c[0], c[1], a[0], c[1]), line(a[0], c[1], a[0], a[1])}}};
    for (const geometry::Boundary& boundary : model.boundaries())
      for (const geometry::PatchFace& on : boundary.faces)
        if (on == geometry::PatchFace{patch, side}) face.name = boundary.name;
    faces.push_back(std::move(face));
  }
  return {geometry::sew(faces).brep, "tube"};
}

// The same cylinder from solids with exact cylinders, degree 2 in every direction; elements through the wall.
KnownProblem cylinder_of_solids() {
  const iga::Material material = iga::isotropic(1000, 0.3);
  const MultiPatch given = geometry::connect(geometry::cylinder_model({.patches_around = 2}));
  std::vector<geometry::BrepFile> solids;
  for (int p = 0; p < given.patch_count(); ++p) solids.push_back(tube_part(given, PatchId(p)));
  const geometry::PatchSet patches =
      segmentation::parameterize(segmentation::hex_model(solids), {.fit = {.degree = 2}}).patches;
  return {"thick cylinder from solids",
          ReferenceKind::closed_form,
          "Lame",
          pressed_cylinder(material, 10, 1, 2),
          [=](int degree, int elements) {
            geometry::PatchSet set = patches;
            std::vector<double> knots;
            for (int i = 1; i < elements; ++i) knots.push_back(double(i) / elements);
            for (geometry::NurbsVolume& patch : set.patches) {
              const Vector3d low = patch.point(patch.low());
              for (int d = 0; d < 3; ++d) {
                geometry::Parameter<3> end = patch.low();
                end[d] = patch.high()[d];
                if (std::abs(patch.point(end).head<2>().norm() - low.head<2>().norm()) < 0.5) continue;
                patch = geometry::insert_knots(geometry::elevate_degree(patch, d, degree - patch.degree(d)),
                                               d, knots);
              }
            }
            const MultiPatch model = geometry::connect(set);
            iga::ElasticityProblem p =
                unloaded(model, {.degree = {1, 1, 1}, .elements_per_direction = {0, 0, 0}}, material);
            add_planes(p, {"start", "end", "bottom", "top"});
            p.surface_loads = {iga::pressure_load("pressure", faces_of(model, "inner"), 10)};
            return p;
          },
          8};
}

// The patches with elements along one direction, so far straight, that grow evenly from its low end, next to
// which the field is steep, to `ratio` times their size at its high end.
geometry::PatchSet graded(geometry::PatchSet set, int direction, int degree, int elements, double ratio) {
  std::vector<double> knots;
  for (int i = 1; i < elements; ++i)
    knots.push_back((std::pow(ratio, static_cast<double>(i) / elements) - 1) / (ratio - 1));
  for (geometry::NurbsVolume& patch : set.patches)
    patch = geometry::insert_knots(
        geometry::elevate_degree(patch, direction, degree - patch.degree(direction)), direction, knots);
  return set;
}

}  // namespace

// A quarter of the plate, 4 hole radii wide and high; exact tractions where it is cut from the infinite one.
KnownProblem plate_with_hole(const iga::Material& material) {
  const ExactSolution exact = pulled_plate_with_hole(material, 1);
  return {"plate with a hole", ReferenceKind::closed_form, "Kirsch", exact, [=](int degree, int elements) {
            const MultiPatch model = geometry::connect(
                graded(geometry::plate_model({.thickness = 0.5}), 0, degree, 2 * elements, 4));
            iga::ElasticityProblem p = unloaded(
                model, {.degree = {degree, degree, 1}, .elements_per_direction = {0, elements, 1}}, material);
            add_planes(p, {"x_min", "y_min", "bottom", "top"});
            std::vector<geometry::PatchFace> cut = faces_of(model, "x_max");
            for (const geometry::PatchFace& face : faces_of(model, "y_max")) cut.push_back(face);
            p.surface_loads = {exact_tractions(cut, exact, material)};
            return p;
          }};
}

// An octant 1 < r < 4; exact tractions on r = 4.
KnownProblem body_with_cavity(const iga::Material& material) {
  const ExactSolution exact = pulled_body_with_cavity(material, 1);
  return {"spherical cavity", ReferenceKind::closed_form, "Goodier", exact, [=](int degree, int elements) {
            const MultiPatch model = geometry::connect(graded(
                geometry::sphere_model({.inner_radius = 1, .outer_radius = 4}), 2, degree, 3 * elements, 5));
            iga::ElasticityProblem p = unloaded(
                model,
                {.degree = {degree, degree, degree}, .elements_per_direction = {elements, elements, 0}},
                material);
            add_planes(p, {"x0", "y0", "z0"});
            p.surface_loads = {exact_tractions(faces_of(model, "outer"), exact, material)};
            return p;
          }};
}

namespace {

iga::FieldValues at(const iga::ElasticitySolution& solution, const Vector3d& place) {
  const iga::Location location = iga::locate(solution.field, place);
  return iga::evaluate(solution.field, location.patch, location.parameter);
}

TEST(ClosedForms, ThickCylinderOrders) {
  for (const Coupling coupling : iga::all_couplings)
    for (const int degree : {1, 2, 3}) expect_orders(pressed_tube(), {degree, {8, 16, 32, 64}, coupling});
}

TEST(ClosedForms, ThickCylinderFromSolidsOrders) {
  for (const int degree : {2, 3}) expect_orders(cylinder_of_solids(), {degree, {16, 32, 64, 128}});
}

void expect_plate_orders(int degree, Coupling coupling) {
  const std::vector<int> elements = degree == 2   ? std::vector{12, 16, 24, 32}
                                    : degree == 3 ? std::vector{8, 12, 16, 24}
                                                  : std::vector{12, 16, 20, 24};
  expect_orders(plate_with_hole(iga::isotropic(1000, 0.3)), {degree, elements, coupling});
}

TEST(ClosedForms, KirschPlateOrders) {
  for (const int degree : {2, 3}) expect_plate_orders(degree, Coupling::elimination);
}

TEST(FullClosedForms, KirschPlateOrders) {
  expect_plate_orders(4, Coupling::elimination);
  for (const int degree : {2, 3, 4}) expect_plate_orders(degree, Coupling::lagrange);
}

TEST(ClosedForms, KirschPlate) {
  const KnownProblem problem = plate_with_hole(iga::isotropic(1000, 0.3));
  const iga::ElasticitySolution s = iga::solve_elasticity(problem.posed(4, 8));
  const iga::FieldValues top = at(s, {0, 1, 0});
  const iga::FieldValues side = at(s, {1, 0, 0});
  const auto claim = [](const std::string& what, const char* unit, double reference, double value,
                        double allowed) {
    expect(Claim{what, unit, ReferenceKind::closed_form, "Kirsch", reference, value, allowed});
  };
  claim("s_xx over the hole, of the tension", "Pa", 3, top.stress(0, 0), 5e-5);
  claim("s_yy beside the hole, of the tension", "Pa", -1, side.stress(1, 1), 1e-4);
  claim("u_x beside the hole", "m", problem.exact.displacement({1, 0, 0})[0], side.displacement[0], 1e-8);
  claim("u_y over the hole", "m", problem.exact.displacement({0, 1, 0})[1], top.displacement[1], 2e-8);
}

void expect_cavity(int degree, int elements, double of_displacement, double of_energy, double of_stress) {
  const iga::ElasticitySolution s =
      iga::solve_elasticity(body_with_cavity(iga::isotropic(1000, 0.3)).posed(degree, elements));
  const iga::FieldValues pole = at(s, {0, 0, 1});
  const iga::FieldValues equator = at(s, {1, 0, 0});
  const auto claim = [&](const std::string& what, const char* unit, double reference, double value,
                         double allowed) {
    expect(Claim{fmt::format("{}, p = {}", what, degree), unit, ReferenceKind::closed_form, "Goodier",
                 reference, value, allowed});
  };
  const double nu = 0.3;
  claim("u_z at the cavity's pole", "m", 2.00454545e-3, pole.displacement[2], of_displacement);
  claim("u_x at its equator", "m", -4.77272727e-4, equator.displacement[0], of_displacement);
  claim("energy of the octant", "J", 1.674667934e-2, s.results.internal_energy, of_energy);
  claim("s_zz at the equator", "Pa", (27 - 15 * nu) / (2 * (7 - 5 * nu)), equator.stress(2, 2),
        of_stress / 2);
  claim("s_xx at the pole", "Pa", -(3 + 15 * nu) / (2 * (7 - 5 * nu)), pole.stress(0, 0), of_stress);
}

TEST(ClosedForms, SphericalCavity) {
  // Energies are accurate to the square of displacements; ten digits of the reference are known.
  expect_cavity(4, 4, 3e-6, 1e-9, 3e-4);
}

// The sphere is of degree 4.
TEST(FullClosedForms, SphericalCavityOrders) {
  for (const Coupling coupling : iga::all_couplings)
    expect_orders(body_with_cavity(iga::isotropic(1000, 0.3)), {4, {5, 6, 7, 8}, coupling, true});
}

}  // namespace
}  // namespace isopatch::verification
