#include "segmentation/decomposition/combinatorics/refinement.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/decomposition/combinatorics/contraction.hpp"
#include "segmentation/decomposition/combinatorics/tests/definitions.hpp"
#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::segmentation {
namespace {

TEST(Refinement, AVertexOnAnEdgeMakesTwoHalvesOfItsKind) {
  CellGraph cube = test::cube();
  cube.edges[2].kind = EdgeKind::non_convex;
  cube.edges[2].angle = Angle::degrees(200);
  const DerivedGraph derived = with_vertex_on_edge(cube, EdgeId(2));
  EXPECT_EQ(CellIncidence(derived.graph).sides(FaceId(0)).size(), derived.graph.faces[0].size());
  EXPECT_EQ(derived.graph.vertex_count, 9);
  EXPECT_EQ(derived.graph.edges.size(), 13u);
  EXPECT_EQ(derived.vertices.back(), LoopPlace::inside(EdgeId(2)));
  for (const int half : {2, 12}) {
    EXPECT_EQ(derived.graph.edges[half].kind, EdgeKind::non_convex);
    EXPECT_EQ(derived.graph.edges[half].angle, Angle::degrees(200));
    EXPECT_EQ(derived.edges[half].front().edge, EdgeId(2));
  }
  EXPECT_EQ(derived.edges[2].front().to, LoopPlace::inside(EdgeId(2)));
  EXPECT_EQ(derived.edges[12].front().from, LoopPlace::inside(EdgeId(2)));
}

TEST(Refinement, AVertexOnAnEdgeAndBackIsTheSame) {
  CellGraph cube = test::cube();
  cube.edges[3].angle = Angle::degrees(80);
  const DerivedGraph there = with_vertex_on_edge(cube, EdgeId(3));
  const auto back = contracted(there.graph, {});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->graph, cube);
  const DerivedGraph both = composed(there, *back);
  EXPECT_EQ(both.vertices, identity(cube).vertices);
  EXPECT_EQ(both.faces, identity(cube).faces);
  ASSERT_EQ(both.edges[3].size(), 2u);
  EXPECT_EQ(both.edges[3][0].from, LoopPlace::at(cube.edges[3].start));
  EXPECT_EQ(both.edges[3][0].to, LoopPlace::inside(EdgeId(3)));
  EXPECT_EQ(both.edges[3][1].to, LoopPlace::at(cube.edges[3].end));
}

TEST(Refinement, AnEdgeAcrossAFaceDividesIt) {
  const CellGraph prism = test::prism(6);
  const FaceId top(7);
  const DerivedGraph derived = with_edge_across_face(prism, top, VertexId(6), VertexId(9));
  EXPECT_EQ(CellIncidence(derived.graph).sides(FaceId(0)).size(), derived.graph.faces[0].size());
  const std::vector<VertexId>& left = derived.graph.faces[7];
  EXPECT_EQ(left.size(), 4u);
  EXPECT_EQ(derived.graph.faces[8].size(), 4u);
  EXPECT_EQ(derived.faces[8].faces, std::vector{top});
  const CellIncidence incidence(derived.graph);
  const EdgeId edge = *incidence.edge_between(VertexId(6), VertexId(9));
  EXPECT_EQ(edge.value, 18);
  EXPECT_EQ(incidence.left(edge), FaceId(7));
  EXPECT_EQ(incidence.right(edge), FaceId(8));
  EXPECT_EQ(derived.graph.edge(edge).kind, EdgeKind::flat);
  const EdgeStretch& stretch = derived.edges[18].front();
  EXPECT_EQ(stretch, (EdgeStretch{LoopPlace::at(VertexId(6)), LoopPlace::at(VertexId(9)), EdgeId(), top}));
  const auto back = contracted(derived.graph, {edge});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->graph.edges, prism.edges);
  EXPECT_EQ(composed(derived, *back).faces, identity(prism).faces);
}

TEST(Refinement, RefusesWhatIsNotThere) {
  const CellGraph cube = test::cube();
  EXPECT_ERROR(with_vertex_on_edge(cube, EdgeId(12)), ErrorCode::invalid_argument, "no edge 12");
  EXPECT_ERROR(with_edge_across_face(cube, FaceId(5), VertexId(4), VertexId(5)), ErrorCode::invalid_argument,
               "that no edge joins");
  EXPECT_ERROR(with_edge_across_face(cube, FaceId(5), VertexId(4), VertexId(2)), ErrorCode::invalid_argument,
               "two of its corners");
  EXPECT_ERROR(with_edge_across_face(cube, FaceId(6), VertexId(4), VertexId(6)), ErrorCode::invalid_argument,
               "no face 6");
}

TEST(Contraction, JoinsTheSidesOfFlatEdges) {
  // A cube whose top is two faces and whose front edge has a vertex of a neighbour on it.
  const CellGraph cube = test::cube();
  const DerivedGraph divided = with_edge_across_face(cube, FaceId(5), VertexId(4), VertexId(6));
  const DerivedGraph with_vertex = with_vertex_on_edge(divided.graph, EdgeId(0));
  const DerivedGraph result = sides(with_vertex.graph);
  EXPECT_EQ(result.graph.edges, cube.edges);
  EXPECT_TRUE(is_three_connected(result.graph));
  EXPECT_EQ(result.faces[5].faces, (std::vector{FaceId(5), FaceId(6)}));
  EXPECT_EQ(result.edges[0].size(), 2u);
}

TEST(Contraction, LeavesFlatEdgesThatTheGraphNeeds) {
  // Without either edge of a tetrahedron two vertices have two edges: it stays as it is.
  const CellGraph tetrahedron = test::with_kind(test::pyramid(3), {{0, 1}}, EdgeKind::flat);
  EXPECT_FALSE(contracted(tetrahedron, {EdgeId(0)}));
  EXPECT_EQ(sides(tetrahedron), identity(tetrahedron));
  // A vertical edge of a cube can go, two of a face cannot.
  const CellGraph cube = test::with_kind(test::cube(), {{0, 4}, {1, 5}}, EdgeKind::flat);
  const DerivedGraph result = sides(cube);
  EXPECT_TRUE(test::three_connected_by_definition(result.graph));
  EXPECT_EQ(result.graph.vertex_count, 6);
}

TEST(Contraction, RefusesWhatIsNoCell) {
  CellGraph open = test::cube();
  open.faces.pop_back();
  EXPECT_ERROR(sides(open), ErrorCode::not_manifold, "no sphere");
  EXPECT_ERROR(contracted(test::cube(), {EdgeId(12)}), ErrorCode::invalid_argument, "no edge 12");
}

TEST(Contraction, KeepsTheWorstKindAndAnglesThatAgree) {
  CellGraph graph = with_vertex_on_edge(test::cube(), EdgeId(1)).graph;
  graph.edges[1].kind = EdgeKind::non_convex;
  graph.edges[1].angle = Angle::degrees(190);
  graph.edges[12].angle = Angle::degrees(90);
  const auto result = contracted(graph, {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->graph.edges[1].kind, EdgeKind::non_convex);
  EXPECT_FALSE(result->graph.edges[1].angle);
}

}  // namespace
}  // namespace isopatch::segmentation
