// What users are told of solids that are neither swept nor cut.

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/decomposition/decompose.hpp"
#include "segmentation/decomposition/known_shape.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::test::made_brep;

/// No search for planes that cut it into pieces, which takes long.
const DecompositionOptions at_once{.time_limit = 0.1};

TEST(Refusals, SayWhatIsInTheWayOfCuttingAndOfSweeping) {
  EXPECT_ERROR(
      decompose(made_brep("rounded_boss_on_fillet"), "boss", at_once), ErrorCode::unsupported,
      "It is no stack to be swept: along x, where the fewest are in the way, 16 faces are neither across");
}

TEST(Refusals, OfSolidsWithRoundsSayThatTheseCanBeRemoved) {
  const std::string why = known_shape(made_brep("rounded_boss_on_fillet"), at_once).why_not;
  EXPECT_NE(why.find("(torus)"), std::string::npos) << why;
  EXPECT_NE(why.find("rounds of 0.003 m at most: with blends = \"remove\" they are taken off"),
            std::string::npos)
      << why;
  EXPECT_NE(why.find("Without its rounds it would be one, but face"), std::string::npos) << why;
  DecompositionOptions small = at_once;
  small.largest_blend = 0.01;
  EXPECT_NE(known_shape(made_brep("rounded_boss_on_fillet"), small).why_not.find("and largest_blend = 0.07"),
            std::string::npos);
}

}  // namespace
}  // namespace isopatch::segmentation
