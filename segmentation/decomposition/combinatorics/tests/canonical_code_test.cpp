#include "segmentation/decomposition/combinatorics/canonical_code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/combinatorics/refinement.hpp"
#include "segmentation/decomposition/combinatorics/tests/definitions.hpp"
#include "segmentation/decomposition/combinatorics/tests/random_graphs.hpp"
#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::segmentation {
namespace {

CodeOptions code_options(bool mirror, bool kinds) {
  CodeOptions options;
  options.mirror_images_are_equal = mirror;
  options.edge_kinds = kinds;
  return options;
}

// Whether some renumbering maps the faces of one onto those of the other, by trying all.
bool isomorphic_by_trial(const CellGraph& a, const CellGraph& b, bool mirrored) {
  const auto key = [](const CellGraph& graph) {
    std::vector<std::vector<int>> faces;
    for (const CellGraph::Corners& corners : graph.faces) {
      std::vector<int> face;
      for (const VertexId vertex : corners) face.push_back(vertex.value);
      while (std::any_of(face.begin() + 1, face.end(), [&](int other) { return other < face.front(); }))
        std::rotate(face.begin(), face.begin() + 1, face.end());
      faces.push_back(face);
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  };
  if (a.vertex_count != b.vertex_count || a.faces.size() != b.faces.size()) return false;
  std::vector<int> numbers(a.vertex_count);
  std::iota(numbers.begin(), numbers.end(), 0);
  const auto wanted = key(b);
  do {
    if (key(test::shuffled(a, numbers, mirrored)) == wanted) return true;
  } while (std::next_permutation(numbers.begin(), numbers.end()));
  return false;
}

TEST(CanonicalCode, DoesNotDependOnNumbers) {
  std::mt19937 random(7);
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const CellGraph graph = test::random_map(seed, 5 + static_cast<int>(seed % 20), test::RandomKind::mixed);
    std::vector<int> numbers(graph.vertex_count);
    std::iota(numbers.begin(), numbers.end(), 0);
    std::shuffle(numbers.begin(), numbers.end(), random);
    const CellGraph other = test::shuffled(graph, numbers, false),
                    image = test::shuffled(graph, numbers, true);
    EXPECT_EQ(canonical_code(graph), canonical_code(other));
    EXPECT_EQ(canonical_code(graph), canonical_code(image));
    EXPECT_EQ(canonical_code(graph, code_options(false, false)),
              canonical_code(other, code_options(false, false)));
  }
}

TEST(CanonicalCode, IsEqualForIsomorphicMapsOnly) {
  std::vector<CellGraph> graphs;
  for (std::uint32_t seed = 0; graphs.size() < 7; ++seed) {
    CellGraph graph = test::random_map(seed, 6, test::RandomKind::mixed);
    if (graph.vertex_count == 6) graphs.push_back(std::move(graph));
  }
  int equal = 0, different = 0;
  for (const CellGraph& a : graphs)
    for (const CellGraph& b : graphs) {
      const bool same = isomorphic_by_trial(a, b, false);
      EXPECT_EQ(
          canonical_code(a, code_options(false, false)) == canonical_code(b, code_options(false, false)),
          same);
      EXPECT_EQ(canonical_code(a) == canonical_code(b), same || isomorphic_by_trial(a, b, true));
      ++(same ? equal : different);
    }
  EXPECT_GT(equal, 7);
  EXPECT_GT(different, 7);
}

TEST(CanonicalCode, TellsMirrorImagesApartWhereAsked) {
  // A prism over a hexagon, its top cut from 6 to 8 and its bottom from 0 to 3: no mirror symmetry left.
  const CellGraph once = with_edge_across_face(test::prism(6), FaceId(7), VertexId(6), VertexId(8)).graph;
  const CellGraph twisted = with_edge_across_face(once, FaceId(6), VertexId(1), VertexId(4)).graph;
  std::vector<int> numbers(12);
  std::iota(numbers.begin(), numbers.end(), 0);
  const CellGraph plain = test::shuffled(twisted, numbers, false),
                  image = test::shuffled(twisted, numbers, true);
  bool mirror = false;
  mirror =
      canonical_code(plain, code_options(false, false)) == canonical_code(image, code_options(false, false));
  EXPECT_EQ(canonical_code(plain), canonical_code(image));
  EXPECT_TRUE(mirror);  // the plane through 1, 7, 4, 10 maps it onto itself
  const CellGraph chiral = with_edge_across_face(once, FaceId(6), VertexId(0), VertexId(3)).graph;
  const CellGraph other_hand = test::shuffled(chiral, numbers, true);
  EXPECT_EQ(canonical_code(chiral), canonical_code(other_hand));
  EXPECT_NE(canonical_code(chiral, code_options(false, false)),
            canonical_code(other_hand, code_options(false, false)));
}

TEST(CanonicalCode, CountsKindsOfEdgesWhereAsked) {
  const CellGraph cube = test::cube();
  const CellGraph one = test::with_kind(cube, {{0, 1}}, EdgeKind::non_convex);
  const CellGraph other = test::with_kind(cube, {{2, 6}}, EdgeKind::non_convex);
  EXPECT_EQ(canonical_code(cube), canonical_code(one));
  EXPECT_NE(canonical_code(cube, code_options(true, true)), canonical_code(one, code_options(true, true)));
  EXPECT_EQ(canonical_code(one, code_options(true, true)), canonical_code(other, code_options(true, true)));
}

TEST(BaseSolid, KnowsItsCorners) {
  for (int n = 3; n <= 7; ++n) {
    const auto prism = base_solid(test::prism(n));
    ASSERT_TRUE(prism);
    EXPECT_EQ(prism->kind, n == 4 ? BaseKind::hexahedron : BaseKind::prism);
    EXPECT_EQ(prism->sides, n);
    for (int k = 0; k < n; ++k)
      EXPECT_TRUE(edge_between(test::prism(n), prism->corners[k], prism->corners[n + k])) << n << " " << k;
    const auto pyramid = base_solid(test::pyramid(n));
    ASSERT_TRUE(pyramid);
    EXPECT_EQ(pyramid->kind, n == 3 ? BaseKind::tetrahedron : BaseKind::pyramid);
    EXPECT_EQ(pyramid->sides, n);
    EXPECT_EQ(pyramid->corners.size(), static_cast<std::size_t>(n + 1));
    EXPECT_EQ(pyramid->corners.back(), VertexId(n == 3 ? 2 : n));
  }
}

TEST(BaseSolid, SeesItsBaseFromInside) {
  const auto prism = base_solid(test::prism(5));
  ASSERT_TRUE(prism);
  std::vector<VertexId> base(prism->corners.begin(), prism->corners.begin() + 5);
  EXPECT_EQ(base, (std::vector{VertexId(0), VertexId(1), VertexId(2), VertexId(3), VertexId(4)}));
  EXPECT_EQ(prism->base, FaceId(5));
}

TEST(BaseSolid, IsNothingElse) {
  EXPECT_FALSE(base_solid(test::bipyramid(3)));
  EXPECT_FALSE(base_solid(test::bipyramid(4)));
  EXPECT_FALSE(base_solid(test::science_park()));
  EXPECT_TRUE(base_solid(test::cut_l_shape()));  // the graph is a prism's; kinds of edges do not count
}

TEST(BaseSolid, TemplatesMakeTheirNumberOfHexahedra) {
  EXPECT_EQ(template_hexahedra(BaseKind::hexahedron, 4), 1);
  EXPECT_EQ(template_hexahedra(BaseKind::tetrahedron, 3), 4);
  EXPECT_EQ(template_hexahedra(BaseKind::pyramid, 4), 8);
  EXPECT_EQ(template_hexahedra(BaseKind::prism, 3), 3);
  EXPECT_EQ(template_hexahedra(BaseKind::prism, 5), 4);
  EXPECT_EQ(template_hexahedra(BaseKind::prism, 8), 3);
}

}  // namespace
}  // namespace isopatch::segmentation
