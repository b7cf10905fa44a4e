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
  const geometry::Brep torus = made_brep("torus");
  EXPECT_ERROR(decompose(torus, "ring"), ErrorCode::unsupported,
               "(face 0 is a torus at (0.007, 0, 0) m). It is no stack to be swept: it has no plane face");
}

TEST(Refusals, OfSolidsWithRoundsSayThatTheseCanBeRemoved) {
  const std::string why = known_shape(made_brep("round_corner"), {}).no_stack;
  EXPECT_NE(why.find("(sphere)"), std::string::npos) << why;
  EXPECT_NE(why.find("rounds of 0.003 m at most: with blends = \"remove\" they are taken off"),
            std::string::npos)
      << why;
  DecompositionOptions small;
  small.largest_blend = 0.05;
  EXPECT_NE(known_shape(made_brep("round_corner"), small).no_stack.find("and largest_blend = 0.08"),
            std::string::npos);
}

}  // namespace
}  // namespace isopatch::segmentation
