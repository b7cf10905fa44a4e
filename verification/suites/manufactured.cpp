// A displacement is chosen, and the forces that cause it follow: orders of convergence on models of every
// kind. The displacement is prescribed on two planes, tractions on all other faces.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geometry/measures.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "verification/suites/known_problem.hpp"
#include "verification/suites/known_problems.hpp"
#include "verification/suites/model_cases.hpp"

namespace isopatch::verification {
namespace {

using Eigen::Vector3d;
using geometry::MultiPatch;
using iga::Coupling;

// The plane of a flat boundary.
Plane plane_of(const MultiPatch& model, const std::string& boundary) {
  const geometry::PatchFace face = faces_of(model, boundary).front();
  const geometry::NurbsVolume& patch = model.patch(face.patch);
  const geometry::NurbsSurface surface = geometry::face_surface(patch, face.side);
  const geometry::Parameter<2> middle = 0.5 * (surface.low() + surface.high());
  const Vector3d normal = geometry::outward_normal(patch, face.side, middle);
  return {normal, normal.dot(surface.point(middle))};
}

// Linear functions cannot follow curved faces: the geometry's degree is a lower bound for theirs.
double curvature(int degree) {
  return degree == 1 ? 0 : 0.2;
}

}  // namespace

KnownProblem manufactured(const std::string& name, const MultiPatch& model,
                          const std::vector<std::string>& held, Wave wave) {
  for (const std::string& boundary : held) wave.planes.push_back(plane_of(model, boundary));
  const iga::Material material = iga::isotropic(1, 0.3);
  const auto posed = [=](int degree, int elements) {
    iga::ElasticityProblem p = unloaded(
        model, {.degree = {degree, degree, degree}, .elements_per_direction = {elements, elements, elements}},
        material);
    std::vector<geometry::PatchFace> loaded = model.boundary_faces();
    for (const std::string& boundary : held) {
      p.supports.push_back(
          {boundary, faces_of(model, boundary), iga::PrescribedDisplacement{.gradient = wave.linear}});
      for (const geometry::PatchFace& face : p.supports.back().faces) std::erase(loaded, face);
    }
    p.surface_loads = {exact_tractions(loaded, wave.exact(), material)};
    p.volume_loads = {
        {"force", all_patches(model), [=](const Vector3d& x) { return wave.body_force(x, material); }}};
    return p;
  };
  return {name, ReferenceKind::manufactured, "", wave.exact(), posed};
}

KnownProblem one_patch(int degree) {
  return manufactured(
      "one distorted patch",
      geometry::connect(geometry::box_model({.distortion = 0.3, .curvature = curvature(degree), .seed = 3})),
      {"x_min", "y_max"});
}

// A livelier wave for the highest degree, or its errors would be round-off.
KnownProblem eight_patches(int degree) {
  Wave wave;
  if (degree == 5) wave.frequency *= 2;
  return manufactured("8 distorted patches in random orientations",
                      geometry::connect(geometry::box_model({.patches = {2, 2, 2},
                                                             .distortion = 0.2,
                                                             .curvature = curvature(degree),
                                                             .seed = 5,
                                                             .orientation_seed = 11})),
                      {"x_min", "y_max"}, wave);
}

// Small beside the wave: on larger sectors coarse meshes converge faster than they will in the end.
KnownProblem manufactured_cylinder() {
  return manufactured("two rational patches of a cylinder",
                      geometry::connect(geometry::cylinder_model({.inner_radius = 1.5,
                                                                  .outer_radius = 2,
                                                                  .height = 0.5,
                                                                  .angle = Angle::degrees(20),
                                                                  .radial_patches = 2})),
                      {"start", "bottom"});
}

// A wedge: the brick (0, 1) x (-1, 1)^2 whose face x = 0 is collapsed to the line y = 0, with a slanted top.
KnownProblem wedge() {
  Eigen::Matrix3Xd points(3, 8);
  Eigen::Index column = 0;
  for (const int z : {0, 1})
    for (const int y : {-1, 1})
      for (const int x : {0, 1})
        points.col(column++) = Vector3d(x, 0.6 * x * y, z * (1 + 0.2 * x + 0.1 * x * y));
  const geometry::KnotVector linear = geometry::KnotVector::bezier(1);
  geometry::PatchSet set{{geometry::NurbsVolume({linear, linear, linear}, points)}, {}, {}};
  set.boundaries = {{"x_max", {{PatchId(0), geometry::Side::east}}},
                    {"bottom", {{PatchId(0), geometry::Side::front}}}};
  return manufactured("a wedge with a collapsed face", geometry::connect(set), {"x_max", "bottom"});
}

namespace {

// One patch has nothing to tie: multipliers must change nothing.
TEST(Manufactured, OnePatch) {
  for (const Coupling coupling : iga::all_couplings)
    for (const int degree : {1, 2, 3}) expect_orders(one_patch(degree), {degree, {4, 6, 8, 12}, coupling});
}

TEST(Manufactured, EightPatches) {
  for (const Coupling coupling : iga::all_couplings) {
    expect_orders(eight_patches(1), {1, {3, 4, 6, 8}, coupling});
    expect_orders(eight_patches(2), {2, {3, 4, 5, 6}, coupling});
  }
}

// Multipliers tie the control points that fall together on the line.
TEST(Manufactured, CollapsedFace) {
  for (const Coupling coupling : iga::all_couplings) {
    expect_orders(wedge(), {1, {6, 8, 12, 16}, coupling});
    expect_orders(wedge(), {2, {8, 10, 12, 16}, coupling});
    expect_orders(wedge(), {3, {4, 6, 8, 12}, coupling});
  }
}

// At p = 1 quadratic around, as the arcs are.
TEST(Manufactured, RationalPatches) {
  for (const Coupling coupling : iga::all_couplings) {
    expect_orders(manufactured_cylinder(), {1, {6, 8, 12, 16}, coupling});
    expect_orders(manufactured_cylinder(), {2, {6, 8, 10, 12}, coupling});
  }
}

// Even degrees on an odd number of elements are a little worse than on the even numbers around it.
TEST(FullManufactured, OnePatch) {
  for (const Coupling coupling : iga::all_couplings)
    for (const int degree : {4, 5})
      expect_orders(one_patch(degree), {degree, {4, 6, 8, 10}, coupling, coupling == Coupling::lagrange});
}

TEST(FullManufactured, EightPatches) {
  for (const Coupling coupling : iga::all_couplings) {
    expect_orders(eight_patches(3), {3, {3, 4, 6, 8}, coupling, true});
    for (const int degree : {4, 5})
      expect_orders(eight_patches(degree), {degree, {4, 6, 8, 10}, coupling, true});
  }
}

TEST(FullManufactured, CollapsedFace) {
  for (const Coupling coupling : iga::all_couplings) {
    expect_orders(wedge(), {4, {6, 8, 10, 12}, coupling});
    expect_orders(wedge(), {5, {4, 6, 8, 10}, coupling});
  }
}

TEST(FullManufactured, RationalPatches) {
  for (const Coupling coupling : iga::all_couplings) {
    expect_orders(manufactured_cylinder(), {3, {4, 6, 8, 12}, coupling});
    expect_orders(manufactured_cylinder(), {4, {4, 6, 8, 10}, coupling});
    expect_orders(manufactured_cylinder(), {5, {5, 6, 8, 10}, coupling});
  }
}

}  // namespace
}  // namespace isopatch::verification
