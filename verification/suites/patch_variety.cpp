// Linear fields on what makes coupling hard: neighbours in every orientation, neighbours refined differently,
// a collapsed face.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/base/larger.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/reorient.hpp"
#include "geometry/splines/refine.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/model_cases.hpp"

namespace isopatch::verification {
namespace {

using geometry::NurbsVolume;
using geometry::PatchSet;

// Error where the whole surface follows the field.
double error_of(const PatchSet& set, const iga::DiscretizationOptions& options, iga::Coupling coupling) {
  const LinearField field = generic_linear_field();
  const geometry::MultiPatch model = geometry::connect(set);
  const iga::ElasticityProblem problem{
      iga::discretize(model, options),
      std::vector<iga::Material>(static_cast<std::size_t>(model.patch_count()), iga::isotropic(1e9, 0.3)),
      {{"surface", model.boundary_faces(), field.prescribed()}},
      {},
      {}};
  return coefficient_error(
      iga::solve_elasticity(problem, {.coupling = coupling, .quadrature_points = 9}).field, field);
}

void expect_exact(const std::string& what, iga::Coupling coupling, double error) {
  expect(Claim{fmt::format("{}, {}: largest error of a coefficient of u", what, iga::name(coupling)),
               "",
               ReferenceKind::exact,
               "linear field",
               0,
               error,
               round_off(1e3, "assembling and solving"),
               {}});
}

TEST(PatchTests, EveryOrientationOfANeighbour) {
  const PatchSet box = geometry::box_model({.patches = {2, 1, 1}, .distortion = 0.3, .curvature = 0.2});
  for (const iga::Coupling coupling : iga::all_couplings) {
    double worst = 0;
    for (const geometry::PatchOrientation& orientation : geometry::patch_orientations()) {
      PatchSet set{box.patches, {}, {}};
      set.patches[1] = geometry::reoriented(box.patches[1], orientation);
      worst = larger(worst, error_of(set, {.refine = 1}, coupling));
    }
    expect_exact("two curved patches, the second in each of 48 orientations", coupling, worst);
  }
}

// Knots at another place and another degree in every patch and direction.
PatchSet refined_differently(PatchSet set) {
  for (std::size_t p = 0; p < set.patches.size(); ++p) {
    NurbsVolume& patch = set.patches[p];
    for (int d = 0; d < 3; ++d) {
      const auto step = static_cast<int>(p) + d;
      const double share = 0.25 + 0.1 * (step % 5);
      patch = geometry::elevate_degree(patch, d, step % 2);
      patch = geometry::insert_knots(patch, d, {patch.knots(d).first() + share * patch.knots(d).length()});
    }
  }
  return set;
}

TEST(PatchTests, NeighboursRefinedDifferently) {
  for (const char* name : {"distorted box", "link"})
    for (const iga::Coupling coupling : iga::all_couplings)
      expect_exact(fmt::format("{}, other knots and degrees in every patch", name), coupling,
                   error_of(refined_differently(patches_of(model_case(name))), {}, coupling));
}

// Places of control points that differ.
int distinct_places(const iga::Discretization& d) {
  std::vector<Eigen::Vector3d> places;
  for (const NurbsVolume& patch : d.patches)
    for (const auto& point : patch.control_points().colwise())
      if (std::none_of(places.begin(), places.end(),
                       [&](const auto& known) { return (known - point).norm() < 1e-9; }))
        places.emplace_back(point);
  return static_cast<int>(places.size());
}

// The west side of a cube pulled together to a line, beside a whole cube.
TEST(PatchTests, CollapsedFace) {
  PatchSet set = geometry::box_model({.patches = {2, 1, 1}});
  Eigen::Matrix3Xd points = set.patches[0].control_points();
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (points(0, i) == 0) points(1, i) = 0.5;
  set = {{NurbsVolume(set.patches[0].knots(), points), set.patches[1]}, {}, {}};
  for (const int degree : {1, 2, 3}) {
    const iga::DiscretizationOptions options{.degree = {degree, degree, degree}, .refine = 1};
    for (const iga::Coupling coupling : iga::all_couplings)
      expect_exact(fmt::format("wedge beside a cube, p = {}", degree), coupling,
                   error_of(set, options, coupling));
    const iga::Discretization d = iga::discretize(geometry::connect(set), options);
    expect(Claim{fmt::format("wedge beside a cube, p = {}: points of the body", degree),
                 "",
                 ReferenceKind::exact,
                 "control points at different places",
                 static_cast<double>(distinct_places(d)),
                 static_cast<double>(iga::global_nodes(d).count()),
                 0,
                 {}});
  }
}

}  // namespace
}  // namespace isopatch::verification
