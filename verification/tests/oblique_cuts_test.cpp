// Solids with curved sides, cut by oblique planes: the blocks' patches are exact.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/decomposition/cutting/tests/across_cell.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::segmentation {
namespace {

TEST(ObliqueCuts, OfABoredBlockLeaveItsPatchesExact) {
  const Eigen::Vector3d normal = Eigen::Vector3d(0.1, -0.06, 1).normalized(), x = normal.unitOrthogonal();
  const geometry::PlaneSurface plane{{0.015, 0.01, 0.005}, x, normal.cross(x)};
  std::vector<geometry::BrepFile> blocks;
  for (const geometry::BrepFile& quarter :
       geometry::read_breps(geometry::test::made_solid("drilled_quarters")).bodies) {
    const CutAttempt attempt =
        samples::cut_across(quarter.brep, one_cell(quarter.brep), geometry::CellId(0), plane);
    ASSERT_TRUE(attempt.cut) << attempt.refusal;
    for (const geometry::Brep& part : cell_solids(quarter.brep, attempt.cut->complex))
      blocks.push_back({part, "block " + std::to_string(blocks.size()), 0});
  }
  ASSERT_EQ(blocks.size(), 8U);
  const Parameterization made = parameterize(hex_model(blocks));
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  EXPECT_LT(made.report.worst_face().deviation, 1e-11 * made.report.size);
  double volume = 0;
  for (const PatchReport& patch : made.report.patches) {
    volume += patch.volume;
    EXPECT_EQ(patch.control_points, 64) << patch.name;  // one element of degree 3: nothing was fitted
  }
  const double exact = 1e-9 * (30 * 20 * 10 - std::numbers::pi * 25 * 10);
  EXPECT_NEAR(volume, exact, 1e-10 * exact);
}

}  // namespace
}  // namespace isopatch::segmentation
