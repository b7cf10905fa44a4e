#include "segmentation/pieces/mirrored_cells.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/pieces/pieced_cells.hpp"
#include "segmentation/sweeps/swept_cells.hpp"
#include "segmentation/sweeps/tests/sound_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::PlaneSurface;

/// Across y.
PlaneSurface plane_at(double y) {
  return {{0, y, 0}, {0, 0, 1}, {1, 0, 0}};
}

geometry::CellComplex halves(const Brep& half) {
  if (auto swept = swept_cells(half)) return std::move(swept->complex);
  return pieced_cells(half).value().complex;
}

/// That each vertex has an image.
void expect_symmetric(const geometry::CellComplex& complex, double y) {
  for (const Eigen::Vector3d& vertex : complex.vertices) {
    const Eigen::Vector3d image(vertex.x(), 2 * y - vertex.y(), vertex.z());
    double nearest = 1;
    for (const Eigen::Vector3d& other : complex.vertices) nearest = smaller(nearest, (other - image).norm());
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(MirroredCells, FillSolidsThatAreSweptOrOfPieces) {
  const std::array<std::pair<const char*, double>, 4> solids = {
      {{"drilled", 0.01}, {"countersunk", 0.01}, {"angle", 0.015}, {"bent_sheet", 0.015}}};
  for (const auto& [name, y] : solids) {
    SCOPED_TRACE(name);
    const Brep solid = geometry::test::made_brep(name);
    const geometry::CellComplex made = mirrored_cells(solid, plane_at(y), halves);
    test::expect_sound(solid, made);
    expect_symmetric(made, y);
  }
}

TEST(MirroredCells, AreNoneOfASolidThatIsNotSymmetric) {
  const Brep solid = geometry::test::made_brep("drilled");
  EXPECT_ERROR(mirrored_cells(solid, plane_at(0.008), halves), ErrorCode::invalid_argument,
               "not symmetric about the plane: 57.78 % of its volume");
  EXPECT_ERROR(mirrored_cells(solid, plane_at(1), halves), ErrorCode::invalid_argument, "not symmetric");
  // Halves of one volume, in the diagonal plane of a block that is no square.
  const Brep block = geometry::test::made_brep("block");
  const Eigen::Vector3d along = Eigen::Vector3d(30, 20, 0).normalized();
  const PlaneSurface diagonal{{0, 0, 0}, along, {0, 0, 1}};
  EXPECT_ERROR(mirrored_cells(block, diagonal, halves), ErrorCode::invalid_argument,
               "nothing is opposite to face");
}

}  // namespace
}  // namespace isopatch::segmentation
