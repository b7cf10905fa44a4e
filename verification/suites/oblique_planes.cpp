// Symmetry planes and rollers in any direction: u.n = 0 on a turned plane is what it is on one along the
// axes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "geometry/base/larger.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/moved_patches.hpp"
#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A model on its planes of symmetry, one of which may be pushed along its normal, under a traction.
struct OnPlanes {
  std::string model;
  std::vector<std::string> planes;
  std::string loaded;
  double pushed = 0;  // of the first plane, m
};

iga::ElasticityProblem problem(const OnPlanes& c, const geometry::PatchSet& set, const Vector3d& traction) {
  const geometry::MultiPatch model = geometry::connect(set);
  iga::ElasticityProblem p{
      iga::discretize(model, {.degree = {2, 2, 2}, .refine = 1}),
      std::vector<iga::Material>(static_cast<std::size_t>(model.patch_count()), iga::isotropic(1000, 0.3)),
      {},
      {},
      {}};
  for (const std::string& plane : c.planes)
    p.supports.push_back(
        {plane, faces_of(model, plane), iga::PlaneSupport{p.supports.empty() ? c.pushed : 0.0}});
  p.surface_loads = {iga::constant_traction("pull", faces_of(model, c.loaded), traction)};
  return p;
}

TEST(PatchTests, SymmetryPlanesTurned) {
  const Matrix3d rotation = oblique_rotation();
  const Vector3d traction(2, -1, 3);
  const std::vector<OnPlanes> cases = {{"distorted box", {"x_min", "y_min", "z_min"}, "x_max"},
                                       {"distorted box", {"x_max", "y_min", "z_min"}, "y_max", 1e-3},
                                       {"sphere", {"x0", "y0", "z0"}, "outer"},
                                       {"plate", {"x_min", "y_min", "bottom"}, "x_max"}};
  for (const OnPlanes& c : cases)
    for (const iga::Coupling coupling : iga::all_couplings) {
      const geometry::PatchSet set = patches_of(model_case(c.model));
      const auto along = iga::solve_elasticity(problem(c, set, traction), {.coupling = coupling});
      const auto turned = iga::solve_elasticity(
          problem(c, moved(set, {rotation, {0, 0, 0}}), rotation * traction), {.coupling = coupling});
      const std::string of = fmt::format("{} on {}planes of symmetry turned obliquely, {}: ", c.model,
                                         c.pushed == 0 ? "" : "rollers and ", iga::name(coupling));
      const auto claim = [&](const std::string& what, double value) {
        expect(Claim{of + what,
                     "",
                     ReferenceKind::other_method,
                     "planes along the axes",
                     0,
                     value,
                     round_off(1e3, "assembling and solving in other coordinates"),
                     {}});
      };
      claim("difference of the displacement, turned back",
            coefficient_difference(along.field, turned.field, rotation.transpose()));
      claim("difference of the energy",
            std::abs(turned.results.internal_energy / along.results.internal_energy - 1));
      double apart = 0, size = 0;
      for (std::size_t s = 0; s < c.planes.size(); ++s) {
        const Vector3d& force = along.results.reactions[s].force;
        apart = larger(apart, (force - rotation.transpose() * turned.results.reactions[s].force).norm());
        size = larger(size, force.norm());
      }
      claim("difference of the reactions, turned back", apart / size);
    }
}

// A sheared box between rollers at 60 degrees to each other. Strain that is the same in all directions normal
// to the edge where these planes meet moves no point out of either.
TEST(PatchTests, RollersAtSixtyDegreesToEachOther) {
  Matrix3d shear = Matrix3d::Identity();
  shear.col(1) << std::cos(std::numbers::pi / 3), std::sin(std::numbers::pi / 3), 0;
  const Matrix3d rotation = oblique_rotation();
  const geometry::MultiPatch model =
      geometry::connect(moved(patches_of(model_case("distorted box")), {rotation * shear, {0, 0, 0}}));
  const LinearField field{Vector3d::Zero(),
                          rotation * Vector3d(1e-3, 1e-3, -4e-4).asDiagonal() * rotation.transpose()};
  const iga::Material material = iga::isotropic(1000, 0.3);
  iga::ElasticityProblem p{iga::discretize(model, {.degree = {2, 2, 2}, .refine = 1}),
                           std::vector<iga::Material>(8, material),
                           {},
                           {},
                           {}};
  for (const char* plane : {"x_min", "y_min", "z_min"})
    p.supports.push_back({plane, faces_of(model, plane), iga::PlaneSupport{}});
  for (const char* face : {"x_max", "y_max", "z_max"})
    p.surface_loads.push_back({face, faces_of(model, face),
                               [stress = field.stress(material)](
                                   const Vector3d&, const Vector3d& n) -> Vector3d { return stress * n; }});
  for (const iga::Coupling coupling : iga::all_couplings) {
    const auto solution = iga::solve_elasticity(p, {.coupling = coupling});
    const std::string of =
        fmt::format("sheared box between rollers at 60 degrees, {}: ", iga::name(coupling));
    expect(Claim{of + "largest error of a coefficient of u",
                 "",
                 ReferenceKind::exact,
                 "linear field",
                 0,
                 coefficient_error(solution.field, field),
                 round_off(100, "assembling and solving"),
                 {}});
    // The planes push with the stress on them: no force along them.
    double friction = 0;
    for (int d = 0; d < 3; ++d) {
      const Vector3d normal = (rotation * shear.inverse().transpose() * Vector3d::Unit(d)).normalized();
      const Vector3d& force = solution.results.reactions[static_cast<std::size_t>(d)].force;
      friction = larger(friction, (force - normal * normal.dot(force)).norm() / force.norm());
    }
    expect(Claim{of + "part of the reactions along the planes",
                 "",
                 ReferenceKind::exact,
                 "no friction",
                 0,
                 friction,
                 round_off(100, "summing the nodes' forces"),
                 {}});
  }
}

// Lame's cylinder is the same in a sector of any angle, one of whose planes then is oblique.
TEST(PatchTests, SectorsOfACylinder) {
  for (const int degrees : {90, 50, 140})
    for (const iga::Coupling coupling : iga::all_couplings) {
      const SolvedStudy s = solved("examples/thick_cylinder/study.toml",
                                   {fmt::format("model.angle={} deg", degrees),
                                    fmt::format("coupling.method={}", iga::name(coupling))});
      const double wall = 1.3e-3 * (10.0 / 3) * (0.4 + 4);
      const std::string of =
          fmt::format("thick cylinder, sector of {} degrees between planes of symmetry, {}: ", degrees,
                      iga::name(coupling));
      expect(Claim{of + "u_r at the inner wall", "m", ReferenceKind::closed_form, "Lame", wall,
                   s.probe("inner wall").values.displacement[0], 5e-10, s.named});
      expect(Claim{of + "energy", "J", ReferenceKind::closed_form, "Lame",
                   0.5 * 10 * wall * 0.5 * degrees * std::numbers::pi / 180,
                   s.run.solution.results.internal_energy, 5e-10, s.named});
    }
}

}  // namespace
}  // namespace isopatch::verification
