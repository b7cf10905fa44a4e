#include "segmentation/decomposition/combinatorics/hexahedra_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/combinatorics/canonical_code.hpp"
#include "segmentation/decomposition/combinatorics/cut_along.hpp"
#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"
#include "segmentation/decomposition/combinatorics/refinement.hpp"
#include "segmentation/decomposition/combinatorics/tests/random_graphs.hpp"
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

TEST(HexahedraCount, OfLShapes) {
  HexahedraCount count;
  EXPECT_EQ(count.minimum(test::cut_l_shape()), 5);
  EXPECT_EQ(count.minimum(test::pointed_l_shape()), 12);
}

TEST(HexahedraCount, OfTheTemplatesIsTheLeast) {
  HexahedraCount count;
  for (int n = 3; n <= 6; ++n) {
    EXPECT_EQ(count.minimum(test::prism(n)),
              template_hexahedra(n == 4 ? BaseKind::hexahedron : BaseKind::prism, n));
    EXPECT_EQ(count.minimum(test::pyramid(n)),
              template_hexahedra(n == 3 ? BaseKind::tetrahedron : BaseKind::pyramid, n));
  }
}

// By the definition: no bounds, no quick cuts.
int plain_minimum(const CellGraph& graph, std::map<CanonicalCode, int>& known) {
  const auto solid = base_solid(graph);
  if (solid && (solid->kind == BaseKind::hexahedron || solid->kind == BaseKind::tetrahedron ||
                (solid->kind == BaseKind::prism && solid->sides == 3)))
    return template_hexahedra(solid->kind, solid->sides);
  const CanonicalCode code = canonical_code(graph);
  if (const auto found = known.find(code); found != known.end()) return found->second;
  int best = 1000000;
  LoopOptions options;
  options.max_length = graph.vertex_count;
  for (const CuttingLoop& loop : valid_loops(graph, options).loops) {
    const CutPieces pieces = cut_along(graph, loop);
    best = smaller(best, plain_minimum(pieces.left.graph, known) + plain_minimum(pieces.right.graph, known));
  }
  return known[code] = best;
}

TEST(HexahedraCount, IsThatOfThePlainRecursion) {
  std::map<CanonicalCode, int> known;
  HexahedraCount count;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const CellGraph graph = test::random_map(seed, 6 + static_cast<int>(seed % 4),
                                             seed % 2 ? test::RandomKind::mixed : test::RandomKind::simple);
    EXPECT_EQ(count.minimum(graph), plain_minimum(graph, known)) << seed;
  }
  EXPECT_GT(count.remembered(), 0);
}

TEST(HexahedraCount, EstimatesWhatIsTooLarge) {
  HexahedraCount count;
  EXPECT_EQ(count.estimate(test::prism(5), 10), 4);
  EXPECT_EQ(count.estimate(test::prism(40), 10), 19);
  EXPECT_EQ(count.remembered(), 1);
  EXPECT_GT(count.estimate(test::science_park(), 10), 3);
  EXPECT_EQ(count.remembered(), 1);
}

TEST(HexahedraCount, RefusesCellsThatTwoVerticesTakeApart) {
  HexahedraCount count;
  EXPECT_ERROR(count.minimum(with_vertex_on_edge(test::cube(), EdgeId(0)).graph),
               ErrorCode::not_three_connected, "3-connected");
}

}  // namespace
}  // namespace isopatch::segmentation
