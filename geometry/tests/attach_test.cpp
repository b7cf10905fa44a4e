#include "geometry/attach.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "geometry/base/error.hpp"
#include "geometry/measures.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

double total_volume(const MultiPatch& model) {
  double sum = 0;
  for (const NurbsVolume& patch : model.patches()) sum += volume(patch);
  return sum;
}

// Two bricks side by side, x in [0, 1] and [1, 2].
PatchSet two_bricks() {
  PatchSet set{{NurbsVolume(), NurbsVolume()}, {}, {}};
  Eigen::Matrix3Xd moved = set.patches[1].control_points();
  moved.row(0).array() += 1;
  set.patches[1] = NurbsVolume(set.patches[1].knots(), moved);
  set.boundaries = {{"top", {{PatchId(0), Side::back}, {PatchId(1), Side::back}}},
                    {"end", {{PatchId(1), Side::east}}}};
  return set;
}

// A quarter of a tube, radii 1 and 2, height 1: the bore is west, rational.
PatchSet quarter_tube() {
  const NurbsVolume brick;
  Eigen::Matrix3Xd points = brick.control_points();
  points.row(0).array() += 1;
  points.row(1).setZero();
  points.row(2) = brick.control_points().row(1);
  const NurbsSurface section({brick.knots(0), brick.knots(1)}, points.leftCols(4));
  return {{revolved(section, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), Angle::degrees(90))}, {}, {}};
}

const std::vector<PatchFace> top = {{PatchId(0), Side::back}, {PatchId(1), Side::back}};

TEST(Attached, LengthensAPartByWhatItIsMoved) {
  const PatchSet set = attached(two_bricks(), top, Eigen::Affine3d(Eigen::Translation3d(0, 0, 0.5)), "roof");
  ASSERT_EQ(set.patches.size(), 4u);
  const MultiPatch model = connect(set);
  EXPECT_EQ(model.interfaces().size(), 4u) << "old and old, two times old and new, new and new";
  EXPECT_NEAR(total_volume(model), 3, 1e-13);
  EXPECT_EQ(model.bodies().size(), 1u);
}

TEST(Attached, MovesBoundariesToTheNewFaces) {
  const PatchSet set = attached(two_bricks(), top, Eigen::Affine3d(Eigen::Translation3d(0, 0, 0.5)), "roof");
  ASSERT_EQ(set.boundaries.size(), 2u);
  EXPECT_EQ(set.boundaries[0].name, "end");
  EXPECT_EQ(set.boundaries[1].name, "roof");
  EXPECT_EQ(set.boundaries[1].faces,
            (std::vector<PatchFace>{{PatchId(2), Side::back}, {PatchId(3), Side::back}}));
  const PatchSet same =
      attached(two_bricks(), {top[0]}, Eigen::Affine3d(Eigen::Translation3d(0, 0, 0.5)), "top");
  EXPECT_EQ(same.boundaries[0].faces,
            (std::vector<PatchFace>{{PatchId(1), Side::back}, {PatchId(2), Side::back}}));
}

TEST(Attached, FillsABoreWithARingOfExactArcs) {
  Eigen::Affine3d shrink(Eigen::Scaling(0.6, 0.6, 1.0));
  const MultiPatch model = connect(attached(quarter_tube(), {{PatchId(0), Side::west}}, shrink));
  EXPECT_EQ(model.interfaces().size(), 1u);
  EXPECT_NEAR(total_volume(model), std::numbers::pi / 4 * (4 - 0.36), 1e-12);
  for (const double t : {0.1, 0.5, 0.8})
    EXPECT_NEAR(model.patch(PatchId(1)).point({t, t, 1}).head<2>().norm(), 0.6, 1e-14);
}

TEST(Attached, RefusesWhatWouldBeNoPatch) {
  const Eigen::Affine3d up(Eigen::Translation3d(0, 0, 0.5));
  const auto message = [](auto call) -> std::string {
    try {
      call();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message([&] {
                attached(two_bricks(), {{PatchId(2), Side::back}}, up);
              }),
              ::testing::HasSubstr("2:back: the model has patches 0 to 1"));
  EXPECT_THAT(message([&] {
                attached(two_bricks(), {top[0], top[0]}, up);
              }),
              ::testing::HasSubstr("0:back is given twice"));
  EXPECT_THAT(message([&] { attached(two_bricks(), top, Eigen::Affine3d::Identity()); }),
              ::testing::HasSubstr("0:back would have no thickness"));
}

}  // namespace
}  // namespace isopatch::geometry
