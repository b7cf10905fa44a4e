#include "segmentation/decomposition/combinatorics/cut_along.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/combinatorics/canonical_code.hpp"
#include "segmentation/decomposition/combinatorics/constructive_loop.hpp"
#include "segmentation/decomposition/combinatorics/internal/hexahedra_estimate.hpp"
#include "segmentation/decomposition/combinatorics/internal/map_cut.hpp"
#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"
#include "segmentation/decomposition/combinatorics/tests/definitions.hpp"
#include "segmentation/decomposition/combinatorics/tests/random_graphs.hpp"
#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::segmentation {
namespace {

EdgeId edge_of(const CellGraph& graph, int a, int b) {
  return *edge_between(graph, VertexId(a), VertexId(b));
}
LoopPlace vertex(int v) {
  return LoopPlace::at(VertexId(v));
}

CuttingLoop loop_of(const CellGraph& graph, const std::vector<LoopPlace>& places) {
  return loop_through(graph, CellIncidence(graph), places);
}

bool is_hexahedron(const CellGraph& graph) {
  const auto solid = base_solid(graph);
  return solid && solid->kind == BaseKind::hexahedron;
}

TEST(CutAlong, ACubeIntoTwoPrisms) {
  CellGraph cube = test::cube();
  cube.edges[static_cast<std::size_t>(edge_of(cube, 0, 4).value)].angle = Angle::degrees(90);
  const CuttingLoop loop = loop_of(cube, {vertex(0), vertex(4), vertex(6), vertex(2)});
  const CutPieces pieces = cut_along(cube, loop);
  for (const DerivedGraph* piece : {&pieces.left, &pieces.right}) {
    EXPECT_EQ(base_solid(piece->graph)->kind, BaseKind::prism);
    EXPECT_TRUE(piece->faces.back().is_new);
    EXPECT_EQ(piece->graph.faces.back().size(), 4u);
    EXPECT_EQ(
        std::count_if(piece->faces.begin(), piece->faces.end(), [](const FaceOrigin& f) { return f.is_new; }),
        1);
    EXPECT_EQ(non_convex_count(piece->graph), 0);
  }
  // Walking 0, 4, 6, 2 seen from outside, wall 0 (0, 1, 5, 4) lies to the right.
  EXPECT_EQ(pieces.right.vertices,
            (std::vector{vertex(0), vertex(1), vertex(2), vertex(4), vertex(5), vertex(6)}));
  EXPECT_EQ(pieces.left.vertices,
            (std::vector{vertex(0), vertex(2), vertex(3), vertex(4), vertex(6), vertex(7)}));
  const auto edge = edge_between(pieces.left.graph, VertexId(0), VertexId(3));  // 0 and 4 there
  ASSERT_TRUE(edge);
  EXPECT_EQ(pieces.left.graph.edge(*edge).angle, Angle::degrees(45));
}

// Everything of a piece lies where its origins say, on random cuts.
TEST(CutAlong, OriginsSayWhereEverythingLies) {
  for (std::uint32_t seed = 0; seed < 25; ++seed) {
    const CellGraph graph = test::random_map(seed, 12, test::RandomKind::mixed);
    const CellIncidence incidence(graph);
    LoopOptions options;
    options.max_length = 5;
    for (int e = 0; e < static_cast<int>(graph.edges.size()); e += 3) options.may_be_split.emplace_back(e);
    for (const CuttingLoop& loop : valid_loops(graph, options).loops) {
      const CutPieces pieces = cut_along(graph, loop);
      for (const DerivedGraph* piece : {&pieces.left, &pieces.right}) {
        const CellIncidence checked(piece->graph);
        for (std::size_t f = 0; f < piece->faces.size(); ++f) {
          if (piece->faces[f].is_new) continue;
          for (const VertexId corner : piece->graph.faces[f]) {
            const auto faces = faces_at(incidence, piece->vertices[corner.value]);
            ASSERT_NE(std::find(faces.begin(), faces.end(), piece->faces[f].faces.front()), faces.end());
          }
        }
        for (std::size_t e = 0; e < piece->edges.size(); ++e) {
          ASSERT_EQ(piece->edges[e].size(), 1u);
          const EdgeStretch& stretch = piece->edges[e].front();
          ASSERT_EQ(stretch.from, piece->vertices[piece->graph.edges[e].start.value]);
          ASSERT_EQ(stretch.to, piece->vertices[piece->graph.edges[e].end.value]);
          ASSERT_NE(stretch.edge.value < 0, stretch.face.value < 0);
        }
      }
    }
  }
}

TEST(CutAlong, ExtendsAWallOfAnLShapeIntoTwoHexahedra) {
  CellGraph graph = test::l_shape();
  graph.edges[edge_of(graph, 3, 9).value].angle = Angle::degrees(270);
  // Wall 2 has corners 2, 3, 9, 8; it walks from 3 to 9, so it lies to the left.
  const EdgeId below = edge_of(graph, 5, 0), above = edge_of(graph, 11, 6);
  CuttingLoop loop =
      loop_of(graph, {vertex(3), vertex(9), LoopPlace::inside(above), LoopPlace::inside(below)});
  loop.steps[0].extension = Extension::left;
  const CutPieces pieces = cut_along(graph, loop);
  EXPECT_TRUE(is_hexahedron(pieces.left.graph));
  EXPECT_TRUE(is_hexahedron(pieces.right.graph));
  EXPECT_EQ(non_convex_count(pieces.left.graph) + non_convex_count(pieces.right.graph), 0);
  // The left one has the wall and the cut as one side, and no vertex 3 or 9.
  const auto joined = std::find_if(pieces.left.faces.begin(), pieces.left.faces.end(),
                                   [](const FaceOrigin& f) { return f.is_new; });
  ASSERT_NE(joined, pieces.left.faces.end());
  EXPECT_EQ(joined->faces, std::vector{FaceId(2)});
  EXPECT_EQ(std::count(pieces.left.vertices.begin(), pieces.left.vertices.end(), vertex(3)), 0);
  EXPECT_EQ(std::count(pieces.right.vertices.begin(), pieces.right.vertices.end(), vertex(3)), 1);
  const auto chain = std::find_if(pieces.left.edges.begin(), pieces.left.edges.end(),
                                  [](const auto& e) { return e.size() == 2; });
  ASSERT_NE(chain, pieces.left.edges.end());
  EXPECT_EQ((*chain)[0].to, (*chain)[1].from);
  // On the other side the edge is left with what is above 180 degrees.
  for (std::size_t e = 0; e < pieces.right.edges.size(); ++e)
    if (pieces.right.edges[e].front().edge == edge_of(graph, 3, 9)) {
      EXPECT_NEAR(pieces.right.graph.edges[e].angle->degrees(), 90, 1e-9);
    }
}

TEST(CutAlong, ExtendsTheFloorOfANotch) {
  const CellGraph graph = test::notched_cube();
  CuttingLoop loop =
      loop_of(graph, {vertex(9), vertex(7), vertex(8), LoopPlace::inside(edge_of(graph, 1, 5)),
                      LoopPlace::inside(edge_of(graph, 0, 4)), LoopPlace::inside(edge_of(graph, 2, 6))});
  loop.steps[0].extension = loop.steps[1].extension = Extension::left;
  const CutPieces pieces = cut_along(graph, loop);
  EXPECT_TRUE(is_hexahedron(pieces.left.graph));
  EXPECT_EQ(canonical_code(pieces.right.graph), canonical_code(test::l_shape()));
  EXPECT_EQ(non_convex_count(pieces.right.graph), 1);
}

TEST(CutAlong, RefusesLoopsThatAreNone) {
  const CellGraph cube = test::cube();
  CuttingLoop loop = loop_of(cube, {vertex(0), vertex(4), vertex(6), vertex(2)});
  loop.places[3] = vertex(0);
  EXPECT_ERROR(cut_along(cube, loop), ErrorCode::invalid_argument, "a place twice");
  loop = loop_of(cube, {vertex(0), vertex(4), vertex(6), vertex(2)});
  loop.steps[0] = LoopStep::across(FaceId(0));
  EXPECT_ERROR(cut_along(cube, loop), ErrorCode::invalid_argument, "beside an edge");
  loop.steps[0] = LoopStep::across(FaceId(1));
  EXPECT_ERROR(cut_along(cube, loop), ErrorCode::invalid_argument, "no corners of one part");
  loop = loop_of(cube, {vertex(4), vertex(5), vertex(6), vertex(7)});
  EXPECT_ERROR(cut_along(cube, loop), ErrorCode::invalid_argument, "fewer than three faces");
}

int number_of_maps() {
  const char* wanted = std::getenv("ISOPATCH_MAPS");
  return wanted ? std::atoi(wanted) : 60;
}

void check_piece(const CellGraph& whole, const CellGraph& piece) {
  ASSERT_TRUE(test::three_connected_by_definition(piece));
  ASSERT_LT(piece.vertex_count, whole.vertex_count);
}

// Random cuts until nothing but base solids is left. How many there are.
int cut_down(const CellGraph& graph, std::mt19937& random) {
  if (base_solid(graph)) return 1;
  LoopOptions options;
  options.max_length = 5;
  options.max_loops = 30;
  const LoopList loops = valid_loops(graph, options);
  const CuttingLoop loop =
      loops.loops.empty() ? constructive_loop(graph) : loops.loops[random() % loops.loops.size()];
  const CutPieces pieces = cut_along(graph, loop);
  for (const DerivedGraph* piece : {&pieces.left, &pieces.right}) {
    check_piece(graph, piece->graph);
    if (testing::Test::HasFatalFailure()) return 0;
  }
  return cut_down(pieces.left.graph, random) + cut_down(pieces.right.graph, random);
}

// ISOPATCH_MAPS=10000 looks at as many maps.
TEST(RandomMaps, EveryCutLeavesTwoSmallerThreeConnectedPieces) {
  for (int seed = 0; seed < number_of_maps(); ++seed) {
    const CellGraph graph = test::random_map(static_cast<std::uint32_t>(seed), 6 + seed % 8,
                                             seed % 2 ? test::RandomKind::mixed : test::RandomKind::simple);
    const PlanarMap map = planar_map(graph);
    const Darts around = darts(map);
    const CellIncidence incidence(graph);
    for (const CuttingLoop& loop : valid_loops(graph).loops) {
      const CutPieces pieces = cut_along(graph, loop);
      check_piece(graph, pieces.left.graph);
      check_piece(graph, pieces.right.graph);
      if (HasFatalFailure()) return;
      // The quick cut of the counting makes the same, and the quick estimate is that of the pieces.
      std::vector<int> path;
      for (const LoopPlace& place : loop.places) path.push_back(place.vertex.value);
      const MapPieces quick = cut(map, around, path);
      ASSERT_EQ(canonical_code(cell_graph(quick.left)), canonical_code(pieces.left.graph));
      ASSERT_EQ(canonical_code(cell_graph(quick.right)), canonical_code(pieces.right.graph));
      ASSERT_NEAR(estimate_change(graph, incidence, loop),
                  hexahedra_estimate(pieces.left.graph) + hexahedra_estimate(pieces.right.graph) -
                      hexahedra_estimate(graph),
                  1e-9);
    }
  }
}

TEST(RandomMaps, RandomCutsEndInBaseSolids) {
  std::mt19937 random(3);
  for (int seed = 0; seed < number_of_maps(); ++seed) {
    const CellGraph graph = test::random_map(static_cast<std::uint32_t>(seed), 6 + seed % 20,
                                             seed % 2 ? test::RandomKind::mixed : test::RandomKind::simple);
    EXPECT_GE(cut_down(graph, random), 1);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace isopatch::segmentation
