#include "segmentation/decomposition/combinatorics/hexahedra_count.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::segmentation {
namespace {

TEST(HexahedraCount, OfPrisms) {
  HexahedraCount count;
  std::vector<int> found;
  for (int n = 3; n <= 8; ++n) found.push_back(count.minimum(test::prism(n)));
  EXPECT_EQ(found, (std::vector<int>{3, 1, 4, 2, 5, 3}));
}

TEST(HexahedraCount, OfPyramidsAndBipyramids) {
  HexahedraCount count;
  EXPECT_EQ(count.minimum(test::pyramid(3)), 4);
  EXPECT_EQ(count.minimum(test::pyramid(4)), 8);
  EXPECT_EQ(count.minimum(test::pyramid(5)), 12);
  EXPECT_EQ(count.minimum(test::pyramid(6)), 16);
  EXPECT_EQ(count.minimum(test::bipyramid(3)), 8);
  EXPECT_EQ(count.minimum(test::bipyramid(4)), 16);  // the octahedron
}

}  // namespace
}  // namespace isopatch::segmentation
