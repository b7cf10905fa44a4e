#include "geometry/topology/edge_graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/topology/graph_connectivity.hpp"
#include "geometry/topology/planar_drawing.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

EdgeGraph graph_of(const Polyhedron& polyhedron) {
  return edge_graph(static_cast<int>(polyhedron.vertices.cols()), polyhedron.faces);
}

ConnectivityReport connectivity_of(const EdgeGraph& graph) {
  return connectivity(graph, topology(graph, boundary(graph)));
}

// Faces of a planar map, some of whose edges go: both sides become one face.
std::vector<std::vector<int>> without_edge(std::vector<std::vector<int>> faces, std::size_t first,
                                           std::size_t at) {
  const int a = faces[first][at], b = faces[first][(at + 1) % faces[first].size()];
  for (std::size_t other = 0; other < faces.size(); ++other)
    for (std::size_t i = 0; i < faces[other].size(); ++i) {
      if (faces[other][i] != b || faces[other][(i + 1) % faces[other].size()] != a || other == first)
        continue;
      std::vector<int> merged;
      for (std::size_t k = 1; k <= faces[first].size(); ++k)
        merged.push_back(faces[first][(at + k) % faces[first].size()]);  // b ... a
      for (std::size_t k = 2; k < faces[other].size(); ++k)
        merged.push_back(faces[other][(i + k) % faces[other].size()]);  // after a, before b
      faces[first] = merged;
      faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(other));
      return faces;
    }
  return faces;
}

// By the definition: no two vertices whose removal leaves the others in pieces. Graphs may have vertices
// without edges.
bool three_connected_by_definition(const EdgeGraph& graph) {
  if (graph.vertex_count < 4) return false;
  std::set<std::pair<int, int>> edges;
  for (const auto& edge : graph.edges) {
    if (edge.start == edge.end) return false;
    const auto [low, high] = std::minmax(edge.start.value, edge.end.value);
    if (!edges.insert({low, high}).second) return false;
  }
  for (int a = 0; a < graph.vertex_count; ++a)
    for (int b = 0; b <= a; ++b) {
      std::vector<int> piece(static_cast<std::size_t>(graph.vertex_count));
      for (std::size_t i = 0; i < piece.size(); ++i) piece[i] = static_cast<int>(i);
      for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [u, v] : edges) {
          if (u == a || v == a || u == b || v == b) continue;
          const int low = std::min(piece[static_cast<std::size_t>(u)], piece[static_cast<std::size_t>(v)]);
          for (const int end : {u, v})
            if (piece[static_cast<std::size_t>(end)] != low)
              piece[static_cast<std::size_t>(end)] = low, changed = true;
        }
      }
      std::set<int> pieces;
      for (int v = 0; v < graph.vertex_count; ++v)
        if (v != a && v != b) pieces.insert(piece[static_cast<std::size_t>(v)]);
      if (pieces.size() > 1) return false;
    }
  return true;
}

TEST(EdgeGraph, ABlockBoundsABallWithACubesGraph) {
  const EdgeGraph graph = graph_of(test::block(1, 2, 3));
  EXPECT_EQ(graph.edges.size(), 12u);
  const BoundaryReport seen = boundary(graph);
  EXPECT_TRUE(seen.bounds_a_solid());
  EXPECT_EQ(seen.shells, 1);
  const TopologyReport kind = topology(graph, seen);
  EXPECT_EQ(kind.euler_characteristic, 2);
  EXPECT_TRUE(kind.contractible);
  EXPECT_TRUE(is_cube(graph, connectivity(graph, kind)));
  EXPECT_FALSE(is_cube(graph_of(test::prism(5)), connectivity_of(graph_of(test::prism(5)))));
}

TEST(EdgeGraph, ATorusHasOneHandle) {
  const EdgeGraph graph = graph_of(test::triangulated_torus(5, 4));
  const TopologyReport kind = topology(graph, boundary(graph));
  EXPECT_EQ(kind.genus, 1);
  EXPECT_FALSE(kind.contractible);
  EXPECT_FALSE(connectivity(graph, kind).three_connected);
}

TEST(EdgeGraph, AnInnerLoopMakesAHandleWhenTheTubeIsOpenAtBothEnds) {
  // A block with a square hole: two faces with inner loops, four walls inside.
  EdgeGraph graph = edge_graph(16, {{0, 1, 5, 4},
                                    {1, 2, 6, 5},
                                    {2, 3, 7, 6},
                                    {3, 0, 4, 7},
                                    {9, 8, 12, 13},
                                    {10, 9, 13, 14},
                                    {11, 10, 14, 15},
                                    {8, 11, 15, 12}});
  const auto use = [&](int from, int to) {
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      const auto& edge = graph.edges[e];
      if (edge.start == VertexId(from) && edge.end == VertexId(to))
        return EdgeUse{EdgeId(static_cast<int>(e)), false};
      if (edge.start == VertexId(to) && edge.end == VertexId(from))
        return EdgeUse{EdgeId(static_cast<int>(e)), true};
    }
    throw std::logic_error("no such edge");
  };
  graph.faces.push_back(
      {{{use(3, 2), use(2, 1), use(1, 0), use(0, 3)}, {use(8, 9), use(9, 10), use(10, 11), use(11, 8)}}});
  graph.faces.push_back(
      {{{use(4, 5), use(5, 6), use(6, 7), use(7, 4)}, {use(15, 14), use(14, 13), use(13, 12), use(12, 15)}}});
  const BoundaryReport seen = boundary(graph);
  ASSERT_TRUE(seen.bounds_a_solid());
  const TopologyReport kind = topology(graph, seen);
  EXPECT_EQ(kind.genus, 1);
  EXPECT_EQ(kind.with_inner_loops.size(), 2u);
  EXPECT_FALSE(connectivity(graph, kind).connected);
}

TEST(EdgeGraph, BreachesOfTheBoundaryAreFound) {
  Polyhedron open = test::block(1, 1, 1);
  open.faces.pop_back();
  EXPECT_EQ(boundary(graph_of(open)).free_edges.size(), 4u);

  Polyhedron turned = test::block(1, 1, 1);
  std::reverse(turned.faces[0].begin(), turned.faces[0].end());
  EXPECT_EQ(boundary(graph_of(turned)).misoriented_edges.size(), 4u);

  Polyhedron wall = test::block(1, 1, 1);
  wall.faces.push_back({0, 1, 7, 6});
  EXPECT_FALSE(boundary(graph_of(wall)).overused_edges.empty());

  // Two tetrahedra that share a vertex.
  const EdgeGraph touching =
      edge_graph(7, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {3, 5, 4}, {3, 4, 6}, {4, 5, 6}, {5, 3, 6}});
  const BoundaryReport seen = boundary(touching);
  EXPECT_THAT(seen.pinched_vertices, testing::ElementsAre(VertexId(3)));
  EXPECT_EQ(seen.shells, 2);
  EXPECT_FALSE(seen.bounds_a_solid());
}

TEST(EdgeGraph, ImpossibleFacesAreRefused) {
  EXPECT_ERROR(edge_graph(3, {{0, 1, 3}}), ErrorCode::invalid_argument, "from vertex 3 to 0");
  EXPECT_ERROR(edge_graph(3, {{0, 1, 1}}), ErrorCode::invalid_argument, "from vertex 1 to 1");
}

TEST(GraphConnectivity, AgreesWithTheDefinitionOnRandomPlanarMaps) {
  std::mt19937 random(7);
  int connected = 0, not_connected = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    std::vector<std::vector<int>> faces = test::random_hull(6 + static_cast<int>(seed % 6), seed).faces;
    // Every edge that goes merges two faces; a face may then meet another twice.
    for (unsigned removed = random() % 6; removed > 0 && faces.size() > 2; --removed) {
      const std::size_t face = random() % faces.size();
      faces = without_edge(faces, face, random() % faces[face].size());
    }
    const EdgeGraph graph = edge_graph(6 + static_cast<int>(seed % 6), faces);
    if (!boundary(graph).bounds_a_solid())
      continue;  // a vertex has lost all edges, or a face walks one twice
    const TopologyReport kind = topology(graph, boundary(graph));
    if (!kind.contractible) continue;
    const ConnectivityReport report = connectivity(graph, kind);
    ASSERT_EQ(report.three_connected, three_connected_by_definition(graph)) << seed;
    ++(report.three_connected ? connected : not_connected);
    if (report.conflict && kind.faces_are_discs() && report.conflict->first != report.conflict->second) {
      EXPECT_NE(report.conflict->u, report.conflict->v);
    }
  }
  EXPECT_GT(connected, 30);
  EXPECT_GT(not_connected, 30);
}

TEST(GraphConnectivity, ThePairOfFacesAndItsVerticesAreNamed) {
  // The two sides of one quadrilateral: faces 0 and 1 share all four vertices, and no edge joins vertices 0
  // and 2.
  const EdgeGraph graph = edge_graph(4, {{0, 1, 2, 3}, {0, 3, 2, 1}});
  const ConnectivityReport report = connectivity_of(graph);
  EXPECT_FALSE(report.three_connected);
  ASSERT_TRUE(report.conflict);
  EXPECT_EQ(report.conflict->first, FaceId(0));
  EXPECT_EQ(report.conflict->second, FaceId(1));
  EXPECT_EQ(std::abs(report.conflict->u.value - report.conflict->v.value), 2);
  EXPECT_EQ(report.low_degree.size(), 4u);
}

// Signed area of a face's polygon.
double signed_area(const EdgeGraph& graph, const Eigen::Matrix2Xd& at, const EdgeGraph::Face& face) {
  const std::vector<VertexId> around = corners(graph, face.loops.front());
  double sum = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Eigen::Vector2d a = at.col(around[i].value), b = at.col(around[(i + 1) % around.size()].value);
    sum += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return sum;
}

TEST(PlanarDrawing, FacesFillTheOuterOneWithoutOverlap) {
  for (const Polyhedron& solid :
       {test::block(1, 1, 1), test::prism(7), test::pyramid(5), test::random_hull(15, 3)}) {
    const EdgeGraph graph = graph_of(solid);
    const Eigen::Matrix2Xd at = planar_drawing(graph, connectivity_of(graph), {.outer = FaceId(0)});
    double sum = 0;
    for (std::size_t f = 1; f < graph.faces.size(); ++f) {
      const double area = signed_area(graph, at, graph.faces[f]);
      EXPECT_LT(area, 0) << f;  // clockwise, all of them: none is folded over
      sum -= area;
      // Convex: every corner turns the same way.
      const auto around = corners(graph, graph.faces[f].loops.front());
      for (std::size_t i = 0; i < around.size(); ++i) {
        const Eigen::Vector2d a = at.col(around[i].value), b = at.col(around[(i + 1) % around.size()].value),
                              c = at.col(around[(i + 2) % around.size()].value);
        EXPECT_LT((b - a).x() * (c - b).y() - (b - a).y() * (c - b).x(), 1e-12);
      }
    }
    EXPECT_NEAR(sum, signed_area(graph, at, graph.faces[0]), 1e-12);
  }
}

TEST(PlanarDrawing, OtherGraphsAreRefused) {
  const EdgeGraph graph = graph_of(test::triangulated_torus(5, 4));
  EXPECT_ERROR(planar_drawing(graph, connectivity_of(graph)), ErrorCode::not_three_connected, "3-connected");
}

}  // namespace
}  // namespace isopatch::geometry
