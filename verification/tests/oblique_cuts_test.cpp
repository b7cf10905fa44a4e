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

geometry::PlaneSurface plane_at(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d n = normal.normalized(), x = n.unitOrthogonal();
  return {origin, x, n.cross(x)};
}

/// Each in two.
std::vector<geometry::Brep> cut(const std::vector<geometry::Brep>& solids,
                                const geometry::PlaneSurface& plane) {
  std::vector<geometry::Brep> parts;
  for (const geometry::Brep& solid : solids) {
    const CutAttempt attempt = samples::cut_across(solid, one_cell(solid), geometry::CellId(0), plane);
    EXPECT_TRUE(attempt.cut) << attempt.refusal;
    if (!attempt.cut) continue;
    for (const geometry::Brep& part : cell_solids(solid, attempt.cut->complex)) parts.push_back(part);
  }
  return parts;
}

/// Patches of one element of degree 3, so that nothing was fitted, that have the volume, m^3.
void expect_exact(const std::vector<geometry::Brep>& parts, double volume) {
  std::vector<geometry::BrepFile> blocks;
  for (const geometry::Brep& part : parts)
    blocks.push_back({part, "block " + std::to_string(blocks.size()), 0});
  const Parameterization made = parameterize(hex_model(blocks));
  EXPECT_TRUE(made.report.usable()) << testing::PrintToString(made.report.complaints());
  EXPECT_LT(made.report.worst_face().deviation, 1e-11 * made.report.size);
  double sum = 0;
  for (const PatchReport& patch : made.report.patches) {
    sum += patch.volume;
    EXPECT_EQ(patch.control_points, 64) << patch.name;
  }
  EXPECT_NEAR(sum, volume, 1e-10 * volume);
}

TEST(ObliqueCuts, OfABoredBlockLeaveItsPatchesExact) {
  std::vector<geometry::Brep> quarters;
  for (const geometry::BrepFile& quarter :
       geometry::read_breps(geometry::test::made_solid("drilled_quarters")).bodies)
    quarters.push_back(quarter.brep);
  const std::vector<geometry::Brep> blocks = cut(quarters, plane_at({0.015, 0.01, 0.005}, {0.1, -0.06, 1}));
  ASSERT_EQ(blocks.size(), 8U);
  expect_exact(blocks, 1e-9 * (30 * 20 * 10 - std::numbers::pi * 25 * 10));
}

}  // namespace
}  // namespace isopatch::segmentation
