#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"

#include <gtest/gtest.h>

#include <map>

#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::segmentation {
namespace {

LoopOptions of_any_length() {
  LoopOptions options;
  options.max_length = 100;
  return options;
}

std::map<int, int> lengths(const LoopList& list) {
  std::map<int, int> count;
  for (const CuttingLoop& loop : list.loops) ++count[loop.length()];
  return count;
}

TEST(LoopEnumeration, CubeHasEightLoopsOfThreeAndSixOfFour) {
  EXPECT_EQ(lengths(valid_loops(test::cube(), of_any_length())), (std::map<int, int>{{3, 8}, {4, 6}}));
}

TEST(LoopEnumeration, PrismsHaveTheirNumberOfLoops) {
  const std::map<int, std::size_t> expected = {{5, 35}, {6, 69}, {7, 112}, {8, 164}};
  for (const auto& [n, count] : expected)
    EXPECT_EQ(valid_loops(test::prism(n), of_any_length()).loops.size(), count) << n;
}

TEST(LoopEnumeration, LoopsOfTheSciencePark) {
  const LoopList list = valid_loops(test::science_park());
  EXPECT_TRUE(list.complete);
  EXPECT_EQ(list.loops.size(), 728u);
}

TEST(LoopEnumeration, LoopsThroughTheConcaveEdgesOfTheSciencePark) {
  const CellGraph graph = test::science_park();
  const std::map<std::pair<int, int>, std::size_t> expected = {{{13, 22}, 53}, {{5, 14}, 44},  {{10, 21}, 44},
                                                               {{13, 17}, 48}, {{17, 19}, 82}, {{19, 22}, 48},
                                                               {{12, 29}, 7}};
  for (const auto& [ends, count] : expected) {
    const EdgeId edge = *edge_between(graph, VertexId(ends.first), VertexId(ends.second));
    EXPECT_EQ(valid_loops_through(graph, edge).loops.size(), count) << ends.first << " - " << ends.second;
  }
}

}  // namespace
}  // namespace isopatch::segmentation
