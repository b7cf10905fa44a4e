#include "iga/post/plane_section.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "geometry/models/cylinder.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

// A displacement that is linear in space: its stress is the same everywhere, on any patches.
ElasticField linear_field(const geometry::MultiPatch& model, const Eigen::Matrix3d& gradient) {
  ElasticField field;
  field.patches = model.patches();
  for (const auto& patch : field.patches) {
    field.displacement.emplace_back(gradient * patch.control_points());
    field.materials.push_back(testing::steel);
  }
  return field;
}

Eigen::Matrix3d some_gradient() {
  Eigen::Matrix3d result;
  result << 1, -2, 0.5, 3, 0.25, -1, 2, 1.5, -0.75;
  return 1e-4 * result;
}

SectionForces cut(const ElasticField& field, const CuttingPlane& plane) {
  return section_forces(field, plane, section_points(field.patches, plane));
}

TEST(PlaneSection, OfABoxIsExact) {
  const auto model = geometry::connect(geometry::box_model({.size = {2, 3, 1}, .patches = {2, 1, 2}}));
  const ElasticField field = linear_field(model, some_gradient());
  const Eigen::Matrix3d sigma = stress(0.5 * (some_gradient() + some_gradient().transpose()), testing::steel);
  // Inside elements, and on a face between two patches, which must count once.
  for (const double x : {0.3, 1.0, 1.7}) {
    const CuttingPlane plane{{x, 1, 0.25}, Eigen::Vector3d::UnitX()};
    const SectionForces found = cut(field, plane);
    const Eigen::Vector3d force = 3 * sigma.col(0), arm(0, 0.5, 0.25);
    EXPECT_NEAR(found.area, 3, 1e-12) << x;
    EXPECT_LE((found.centre - Eigen::Vector3d(x, 1.5, 0.5)).norm(), 1e-12) << x;
    EXPECT_LE((found.force - force).norm(), 1e-11 * force.norm()) << x;
    EXPECT_LE((found.moment - arm.cross(force)).norm(), 1e-11 * force.norm()) << x;
  }
  // Obliquely: 2 x 3 x 1 cut along the diagonal of its top.
  const CuttingPlane oblique{{1, 1.5, 0.5}, Eigen::Vector3d(3, -2, 0).normalized()};
  const SectionForces found = cut(field, oblique);
  EXPECT_NEAR(found.area, std::sqrt(13), 1e-12);
  EXPECT_LE((found.force - std::sqrt(13) * sigma * oblique.normal).norm(), 1e-11 * found.force.norm());
}

TEST(PlaneSection, OfCurvedPatchesConvergesToTheAreaOfTheBody) {
  const ElasticField field = linear_field(testing::distorted_box(), some_gradient());
  const Eigen::Matrix3d sigma = stress(0.5 * (some_gradient() + some_gradient().transpose()), testing::steel);
  const SectionForces found = cut(field, {{0.37, 0.5, 0.5}, Eigen::Vector3d::UnitX()});
  // Curved inside, a unit square outside; diagonals of two patches need not agree on their interface.
  EXPECT_NEAR(found.area, 1, 1e-4);
  EXPECT_LE((found.force - sigma.col(0)).norm(), 1e-4 * sigma.col(0).norm());
}

// A quarter ring of radii 1 and 2: its outline is an arc, here of at least four parabolas: Simpson's rule.
TEST(PlaneSection, OfARoundOutline) {
  const auto model =
      geometry::connect(geometry::cylinder_model({.inner_radius = 1, .outer_radius = 2, .height = 1}));
  const ElasticField field = linear_field(model, some_gradient());
  const SectionForces found = cut(field, {{0, 0, 0.4}, Eigen::Vector3d::UnitZ()});
  EXPECT_NEAR(found.area, 0.75 * std::numbers::pi, 1e-4);
}

// Faces of elements that lie in the plane but for round-off count once.
TEST(PlaneSection, AlongFacesOfElements) {
  const auto model = geometry::connect(
      geometry::cylinder_model({.inner_radius = 1, .outer_radius = 2, .height = 1, .patches_around = 4}));
  const ElasticField field = linear_field(model, some_gradient());
  const double diagonal = std::numbers::pi / 4;
  const Eigen::Vector3d normal(-std::sin(diagonal), std::cos(diagonal), 0);
  EXPECT_NEAR(cut(field, {{0, 0, 0.5}, normal}).area, 1, 1e-9);
}

TEST(PlaneSection, WithARadiusCutsOneArm) {
  const auto model =
      geometry::connect(geometry::cylinder_model({.inner_radius = 1, .outer_radius = 2, .height = 1}));
  const ElasticField field = linear_field(model, some_gradient());
  // y = 0.1 cuts the quarter once; a disc of radius 0.1 sees a part of that.
  const CuttingPlane whole{{1.5, 0.1, 0.5}, Eigen::Vector3d::UnitY()};
  CuttingPlane disc = whole;
  disc.radius = 0.25;
  EXPECT_LT(cut(field, disc).area, 0.5 * cut(field, whole).area);
  EXPECT_NEAR(cut(field, disc).area, std::numbers::pi * 0.0625, 0.05);  // by whole triangles
}

TEST(PlaneSection, BesideThePartIsEmpty) {
  const auto model = geometry::connect(geometry::box_model({}));
  EXPECT_TRUE(section_points(model.patches(), {{2, 0, 0}, Eigen::Vector3d::UnitX()}).empty());
}

}  // namespace
}  // namespace isopatch::iga
