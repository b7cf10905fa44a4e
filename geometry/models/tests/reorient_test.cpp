#include "geometry/models/reorient.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <set>

#include "geometry/models/cylinder.hpp"

namespace isopatch::geometry {
namespace {

TEST(Reorient, The48OrientationsDifferAndHalfKeepTheHandedness) {
  const NurbsVolume patch = cylinder_model().patches[0];
  std::set<PatchOrientation> different;
  int index = 0;
  for (const PatchOrientation& orientation : patch_orientations()) {
    different.insert(orientation);
    const double det = reoriented(patch, orientation).jacobian({0.5, 0.5, 0.5}).determinant();
    EXPECT_EQ(det > 0, index++ < 24);
  }
  EXPECT_EQ(different.size(), 48u);
}

TEST(Reorient, ASideIsFoundWhereItWent) {
  const NurbsVolume patch = cylinder_model().patches[0];
  for (const PatchOrientation& orientation : patch_orientations()) {
    const NurbsVolume other = reoriented(patch, orientation);
    for (const Side side : all_sides) {
      const Eigen::Vector3d before = face_surface(patch, side).point({0.5, 0.5});
      const Eigen::Vector3d after = face_surface(other, reoriented(side, orientation)).point({0.5, 0.5});
      EXPECT_LE((before - after).norm(), 1e-15);
    }
  }
}

TEST(Reorient, BoundariesAndInterfacesFollow) {
  const PatchSet patches = cylinder_model({.angle = Angle::degrees(180)});
  for (unsigned seed = 0; seed < 10; ++seed) {
    const PatchSet other = randomly_reoriented(patches, seed);
    ASSERT_EQ(other.boundaries.size(), patches.boundaries.size());
    EXPECT_EQ(other.boundaries[0].name, patches.boundaries[0].name);
    ASSERT_EQ(other.interfaces.size(), 1u);
    // connect() refuses an interface that the geometry refutes, in its sides or its orientation.
    const MultiPatch model = connect(other);
    EXPECT_EQ(model.interfaces().size(), 1u);
  }
}

}  // namespace
}  // namespace isopatch::geometry
