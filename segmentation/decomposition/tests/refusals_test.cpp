// What users are told of solids that are neither swept nor cut.

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/decomposition/decompose.hpp"
#include "segmentation/decomposition/known_shape.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::test::made_brep;

TEST(Refusals, SayWhatIsInTheWayOfCuttingAndOfSweeping) {
  EXPECT_ERROR(
      decompose(made_brep("filleted_boss"), "boss"), ErrorCode::unsupported,
      "It is no stack to be swept: along z, where the fewest are in the way, 1 face is neither across");
}

TEST(Refusals, OfSolidsWithRoundsSayThatTheseCanBeRemoved) {
  const std::string why = known_shape(made_brep("filleted_boss"), {}).why_not;
  EXPECT_NE(why.find("(torus)"), std::string::npos) << why;
  EXPECT_NE(why.find("rounds of 0.002 m at most: with blends = \"remove\" they are taken off"),
            std::string::npos)
      << why;
  DecompositionOptions small;
  small.largest_blend = 0.02;
  EXPECT_NE(known_shape(made_brep("filleted_boss"), small).why_not.find("and largest_blend = 0.05"),
            std::string::npos);
}

}  // namespace
}  // namespace isopatch::segmentation
