#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"
#include "segmentation/decomposition/combinatorics/contraction.hpp"
#include "segmentation/decomposition/combinatorics/refinement.hpp"
#include "segmentation/decomposition/combinatorics/tests/definitions.hpp"
#include "segmentation/decomposition/combinatorics/tests/random_graphs.hpp"
#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::segmentation {
namespace {

TEST(CellGraph, SurvivesTheWayThroughAnEdgeGraph) {
  const CellGraph graph = test::prism(5);
  EXPECT_EQ(cell_graph(edge_graph(graph)), graph);
}

TEST(CellGraph, RefusesFacesThatAreNone) {
  EXPECT_ERROR(cell_graph(3, {{0, 1}}), ErrorCode::invalid_argument, "three are the fewest");
  EXPECT_ERROR(cell_graph(3, {{0, 1, 3}}), ErrorCode::invalid_argument, "range 0 .. 2");
  geometry::EdgeGraph lens = geometry::edge_graph(2, {{0, 1}, {1, 0}});
  lens.edges.push_back(lens.edges.front());
  EXPECT_ERROR(cell_graph(lens), ErrorCode::unsupported, "have an edge already");
}

TEST(CellGraph, CountsNonConvexEdges) {
  EXPECT_EQ(non_convex_count(test::cube()), 0);
  EXPECT_EQ(non_convex_count(test::science_park()), 7);
}

TEST(CellIncidence, GoesCounterClockwiseAroundAVertex) {
  const CellGraph graph = test::cube();
  const CellIncidence incidence(graph);
  for (int v = 0; v < graph.vertex_count; ++v) {
    const VertexId vertex(v);
    const std::vector<FaceId>& faces = incidence.faces_at(vertex);
    for (std::size_t k = 0; k < faces.size(); ++k) {
      // Edge k leaves the vertex with face k to its left.
      const EdgeId edge = incidence.edges_at(vertex)[k];
      EXPECT_EQ(graph.edge(edge).start == vertex ? incidence.left(edge) : incidence.right(edge), faces[k]);
      const EdgeId next = incidence.edges_at(vertex)[(k + 1) % faces.size()];
      EXPECT_EQ(graph.edge(next).start == vertex ? incidence.right(next) : incidence.left(next), faces[k]);
    }
  }
  EXPECT_EQ(incidence.common_faces(VertexId(0), VertexId(1)).size(), 2u);
  EXPECT_EQ(incidence.common_faces(VertexId(0), VertexId(2)).size(), 1u);
  EXPECT_EQ(incidence.common_faces(VertexId(0), VertexId(6)).size(), 0u);
}

TEST(CellIncidence, RefusesWhatBoundsNoBall) {
  CellGraph open = test::cube();
  open.faces.pop_back();
  EXPECT_ERROR(CellIncidence(open), ErrorCode::not_manifold, "no sphere");
  CellGraph turned = test::cube();
  std::swap(turned.faces[0][0], turned.faces[0][2]);
  EXPECT_ERROR(CellIncidence(turned), ErrorCode::not_manifold, "no sphere");
  CellGraph two = test::cube();
  for (CellGraph::Corners face : test::cube().faces) {
    for (VertexId& vertex : face) vertex.value += 8;
    two.faces.push_back(face);
  }
  two.vertex_count = 16;
  EXPECT_ERROR(CellIncidence(two), ErrorCode::not_manifold, "no sphere");
  CellGraph missing = test::cube();
  missing.edges.pop_back();
  EXPECT_ERROR(CellIncidence(missing), ErrorCode::not_manifold, "not the sides");
}

// Random maps, and what is left of them without an edge or two: both answers occur often.
TEST(CellIncidence, ThreeConnectivityIsThatOfTheDefinition) {
  int connected = 0, not_connected = 0;
  for (std::uint32_t seed = 0; seed < 120; ++seed) {
    const CellGraph whole = test::random_map(seed, 6 + static_cast<int>(seed % 7),
                                             seed % 2 ? test::RandomKind::mixed : test::RandomKind::simple);
    EXPECT_TRUE(is_three_connected(whole));
    EXPECT_TRUE(test::three_connected_by_definition(whole));
    const int edges = static_cast<int>(whole.edges.size());
    for (int first = 0; first < edges; ++first) {
      const auto less = contracted(whole, {EdgeId(first), EdgeId((first + 3) % edges)});
      if (!less) continue;
      const bool expected = test::three_connected_by_definition(less->graph);
      EXPECT_EQ(is_three_connected(less->graph), expected) << seed;
      ++(expected ? connected : not_connected);
    }
  }
  EXPECT_GT(connected, 10);
  EXPECT_GT(not_connected, 10);
}

TEST(CellIncidence, AVertexOfDegreeTwoIsNot3Connected) {
  EXPECT_FALSE(is_three_connected(with_vertex_on_edge(test::cube(), EdgeId(0)).graph));
}

}  // namespace
}  // namespace isopatch::segmentation
