#include "segmentation/decomposition/decomposition_options.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::segmentation {
namespace {

using Eigen::Vector3d;

constexpr ErrorCode wrong = ErrorCode::invalid_argument;

TEST(DecompositionOptions, NameWhatIsOutOfRange) {
  EXPECT_ERROR(validate(DecompositionOptions{.time_limit = 0}), wrong, "time_limit is 0");
  EXPECT_ERROR(validate(DecompositionOptions{.largest_blend = -1}), wrong, "largest_blend is -1");
  EXPECT_ERROR(validate(DecompositionOptions{.max_cells = 0}), wrong, "max_cells is 0");
}

TEST(DecompositionOptions, CutsByHandAreNotForTheMethodThatCutsAlongLoops) {
  const GivenPlane across{.normal = Vector3d(1, 0, 0)};
  const char* why = "cuts by hand and symmetry lead to pieces that are swept; the method cuts has none";
  EXPECT_ERROR(validate(DecompositionOptions{.method = Method::cuts, .cuts = {across}}), wrong, why);
  EXPECT_ERROR(validate(DecompositionOptions{.method = Method::cuts, .symmetry = across}), wrong, why);
  validate(DecompositionOptions{.cuts = {across}, .symmetry = across});  // by pieces: no error
}

TEST(GivenPlane, IsGivenInOneWay) {
  EXPECT_ERROR(validate(GivenPlane{}), wrong, "by one of normal, face and through");
  EXPECT_ERROR(validate(GivenPlane{.normal = Vector3d(1, 0, 0), .face = "face 1"}), wrong, "by one of");
  EXPECT_ERROR(validate(GivenPlane{.point = Vector3d(1, 0, 0), .face = "face 1"}), wrong,
               "a plane with a point needs its normal");
  EXPECT_ERROR(validate(GivenPlane{.normal = Vector3d(0, 0, 0)}), wrong, "has no length");
  EXPECT_ERROR(validate(GivenPlane{.through = {{0, 0, 0}, {1, 0, 0}}}), wrong,
               "goes through three points or more; 2 are given");
}

// The faces of a cylinder: its wall and two discs.
TEST(GivenPlane, OfAFaceNeedsAPlaneOne) {
  const geometry::Brep solid = geometry::test::made_brep("cylinder");
  int plane = 0, round = 0;
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f) {
    const GivenPlane given{.face = "face " + std::to_string(f)};
    if (solid.carrier(FaceId(f))->kind == geometry::SurfaceKind::plane) {
      const geometry::PlaneSurface found = plane_of(solid, given);
      EXPECT_NEAR(std::abs(found.normal().dot(solid.carrier(FaceId(f))->axis)), 1, 1e-14);
      ++plane;
    } else {
      EXPECT_ERROR(plane_of(solid, given), wrong, "is not plane, so that it cannot be extended as a cut");
      ++round;
    }
  }
  EXPECT_EQ(plane, 2);
  EXPECT_GE(round, 1);
  EXPECT_ERROR(plane_of(solid, {.face = "lid"}), wrong, "there is no face 'lid' to be extended");
}

}  // namespace
}  // namespace isopatch::segmentation
