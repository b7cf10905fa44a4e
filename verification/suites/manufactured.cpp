// A displacement is chosen, and the forces that cause it follow: orders of convergence on models of every
// kind.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geometry/models/box.hpp"
#include "iga/solve_elasticity.hpp"
#include "verification/claims/claim.hpp"
#include "verification/suites/exact_solution.hpp"

namespace isopatch::verification {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// u = A x + (n.x - d) sin(a.x) c: linear on the plane n.x = d, where it is prescribed; smooth and not a
// polynomial elsewhere.
struct Wave {
  Vector3d normal = {1, 0, 0};
  double plane = 0;
  Vector3d frequency = {1.1, 0.8, -0.6};
  Vector3d direction = {0.3, -0.5, 0.4};
  Matrix3d linear = (Matrix3d() << 0.10, 0.02, -0.03, 0.04, -0.05, 0.06, 0.07, -0.01, 0.03).finished();

  double height(const Vector3d& x) const { return normal.dot(x) - plane; }
  double phase(const Vector3d& x) const { return frequency.dot(x); }
  Vector3d slope(const Vector3d& x) const {
    return std::sin(phase(x)) * normal + height(x) * std::cos(phase(x)) * frequency;
  }
  Matrix3d curvature(const Vector3d& x) const {
    return std::cos(phase(x)) * (normal * frequency.transpose() + frequency * normal.transpose()) -
           height(x) * std::sin(phase(x)) * frequency * frequency.transpose();
  }
  Vector3d displacement(const Vector3d& x) const {
    return linear * x + height(x) * std::sin(phase(x)) * direction;
  }
  Matrix3d gradient(const Vector3d& x) const { return linear + direction * slope(x).transpose(); }
  // -div sigma.
  Vector3d body_force(const Vector3d& x, const iga::Material& m) const {
    const Matrix3d h = curvature(x);
    return -((m.lambda + m.mu) * h * direction + m.mu * h.trace() * direction);
  }
  ExactSolution exact() const {
    return {[w = *this](const Vector3d& x) { return w.displacement(x); },
            [w = *this](const Vector3d& x) { return w.gradient(x); }};
  }
};

// A model with the name of the plane face on which the displacement is prescribed.
struct Case {
  std::string name;
  geometry::MultiPatch model;
  std::string fixed;
  Wave wave;
};

iga::ElasticityProblem problem(const Case& c, int degree, int elements) {
  const iga::Material material = iga::isotropic(1, 0.3);
  iga::ElasticityProblem p{
      iga::discretize(c.model, {.degree = {degree, degree, degree},
                                .elements_per_direction = {elements, elements, elements}}),
      std::vector<iga::Material>(static_cast<std::size_t>(c.model.patch_count()), material),
      {},
      {},
      {}};
  iga::PrescribedDisplacement held;
  held.gradient = c.wave.linear;
  std::vector<geometry::PatchFace> loaded = c.model.boundary_faces();
  for (const geometry::Boundary& boundary : c.model.boundaries()) {
    if (boundary.name != c.fixed) continue;
    p.supports = {{"plane", boundary.faces, held}};
    for (const geometry::PatchFace& face : boundary.faces) std::erase(loaded, face);
  }
  p.surface_loads = {
      {"tractions", loaded, [=, wave = c.wave](const Vector3d& x, const Vector3d& n) -> Vector3d {
         return stress_of(wave.gradient(x), material) * n;
       }}};
  std::vector<PatchId> all;
  for (int i = 0; i < c.model.patch_count(); ++i) all.emplace_back(i);
  p.volume_loads = {
      {"force", all, [=, wave = c.wave](const Vector3d& x) { return wave.body_force(x, material); }}};
  return p;
}

void expect_orders(const Case& c, int degree, const std::vector<int>& levels, iga::Coupling coupling) {
  const std::string of = fmt::format("{}, p = {}, {}", c.name, degree, iga::name(coupling));
  Convergence displacement{.what = "displacement in L2, " + of,
                           .kind = ReferenceKind::manufactured,
                           .source = "p + 1",
                           .order = degree + 1.0};
  Convergence energy{.what = "energy norm, " + of,
                     .kind = ReferenceKind::manufactured,
                     .source = "p",
                     .order = static_cast<double>(degree)};
  for (const int elements : levels) {
    const iga::ElasticitySolution solution = iga::solve_elasticity(
        problem(c, degree, elements), {.coupling = coupling, .quadrature_points = degree + 2});
    const Errors e = errors(solution.field, c.wave.exact(), degree + 3);
    for (Convergence* claim : {&displacement, &energy}) claim->sizes.push_back(1.0 / elements);
    displacement.errors.push_back(e.displacement);
    energy.errors.push_back(e.energy);
  }
  expect(displacement);
  expect(energy);
}

// Linear functions cannot follow curved faces: the geometry's degree is a lower bound for theirs.
double curvature(int degree) {
  return degree == 1 ? 0 : 0.2;
}

Case one_patch(int degree) {
  return {
      "one distorted patch",
      geometry::connect(geometry::box_model({.distortion = 0.3, .curvature = curvature(degree), .seed = 3})),
      "x_min",
      {}};
}

Case eight_patches(int degree) {
  return {"8 distorted patches in random orientations",
          geometry::connect(geometry::box_model({.patches = {2, 2, 2},
                                                 .distortion = 0.2,
                                                 .curvature = curvature(degree),
                                                 .seed = 5,
                                                 .orientation_seed = 11})),
          "x_min",
          {}};
}

TEST(Manufactured, OnePatch) {
  for (const int degree : {1, 2, 3})
    expect_orders(one_patch(degree), degree, {4, 6, 9, 14}, iga::Coupling::elimination);
}

TEST(Manufactured, EightPatches) {
  for (const auto coupling : {iga::Coupling::elimination, iga::Coupling::lagrange})
    for (const int degree : {1, 2}) expect_orders(eight_patches(degree), degree, {2, 3, 5, 8}, coupling);
}

}  // namespace
}  // namespace isopatch::verification
