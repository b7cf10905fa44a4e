#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/decomposition/combinatorics/constructive_loop.hpp"
#include "segmentation/decomposition/combinatorics/internal/separation.hpp"
#include "segmentation/decomposition/combinatorics/loop_validity.hpp"
#include "segmentation/decomposition/combinatorics/refinement.hpp"
#include "segmentation/decomposition/combinatorics/tests/definitions.hpp"
#include "segmentation/decomposition/combinatorics/tests/random_graphs.hpp"
#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::segmentation {
namespace {

LoopOptions up_to(int length, std::vector<EdgeId> may_be_split = {}) {
  LoopOptions options;
  options.max_length = length;
  options.may_be_split = std::move(may_be_split);
  return options;
}

EdgeId edge(const CellGraph& graph, int a, int b) {
  return *edge_between(graph, VertexId(a), VertexId(b));
}

std::map<int, int> lengths(const LoopList& list) {
  std::map<int, int> count;
  for (const CuttingLoop& loop : list.loops) ++count[loop.length()];
  return count;
}

TEST(LoopEnumeration, CubeHasEightLoopsOfThreeAndSixOfFour) {
  EXPECT_EQ(lengths(valid_loops(test::cube(), up_to(100))), (std::map<int, int>{{3, 8}, {4, 6}}));
}

TEST(LoopEnumeration, PrismsHaveTheirNumberOfLoops) {
  const std::map<int, std::size_t> expected = {{5, 35}, {6, 69}, {7, 112}, {8, 164}};
  for (const auto& [n, count] : expected)
    EXPECT_EQ(valid_loops(test::prism(n), up_to(100)).loops.size(), count) << n;
}

TEST(LoopEnumeration, LoopsOfTheSciencePark) {
  const LoopList list = valid_loops(test::science_park());
  EXPECT_TRUE(list.complete);
  EXPECT_EQ(list.loops.size(), 728u);
  EXPECT_EQ(valid_loops(test::science_park(), up_to(9)).loops.size(), 1404u);
}

TEST(LoopEnumeration, LoopsThroughTheNonConvexEdgesOfTheSciencePark) {
  const CellGraph graph = test::science_park();
  const std::map<std::pair<int, int>, std::size_t> expected = {{{13, 22}, 53}, {{5, 14}, 44},  {{10, 21}, 44},
                                                               {{13, 17}, 48}, {{17, 19}, 82}, {{19, 22}, 48},
                                                               {{12, 29}, 7}};
  for (const auto& [ends, count] : expected)
    EXPECT_EQ(valid_loops_through(graph, edge(graph, ends.first, ends.second)).loops.size(), count)
        << ends.first << " - " << ends.second;
}

TEST(LoopEnumeration, LoopsOfTheLShapes) {
  const CellGraph cut = test::cut_l_shape(), pointed = test::pointed_l_shape();
  EXPECT_EQ(valid_loops(cut, up_to(100)).loops.size(), 112u);
  EXPECT_EQ(lengths(valid_loops_through(cut, edge(cut, 4, 5), up_to(100))), (std::map<int, int>{{4, 10}}));
  EXPECT_EQ(valid_loops(pointed, up_to(100)).loops.size(), 43u);
  EXPECT_EQ(lengths(valid_loops_through(pointed, edge(pointed, 4, 5), up_to(100))),
            (std::map<int, int>{{3, 1}, {4, 4}}));
}

// Every cycle of places that share faces, tried one after the other.
void try_all(const CellGraph& graph, const std::vector<LoopPlace>& places, int length,
             const std::function<void(const CuttingLoop&)>& visit) {
  const CellIncidence incidence(graph);
  const auto share = [&](const LoopPlace& a, const LoopPlace& b) {
    for (const FaceId face : faces_at(incidence, a))
      for (const FaceId other : faces_at(incidence, b))
        if (face == other) return true;
    return false;
  };
  std::vector<LoopPlace> path;
  const std::function<void()> grow = [&] {
    if (path.size() >= 3 && path[1] < path.back() && share(path.back(), path.front()))
      visit(loop_through(graph, incidence, path));
    if (static_cast<int>(path.size()) == length) return;
    for (const LoopPlace& place : places) {
      if (!path.empty() && (!share(path.back(), place) || place <= path.front())) continue;
      if (std::find(path.begin(), path.end(), place) != path.end()) continue;
      path.push_back(place);
      grow();
      path.pop_back();
    }
  };
  grow();
}

std::vector<LoopPlace> vertices_of(const CellGraph& graph) {
  std::vector<LoopPlace> result;
  for (int v = 0; v < graph.vertex_count; ++v) result.push_back(LoopPlace::at(VertexId(v)));
  return result;
}

bool cuts_well(const CellGraph& graph, const CuttingLoop& loop) {
  const Separation cut = separate(graph, loop);
  return cut.pieces && test::three_connected_by_definition(cut.pieces->left.graph) &&
         test::three_connected_by_definition(cut.pieces->right.graph);
}

// By the rule, by the definition, and by the search: the same loops.
TEST(LoopEnumeration, FindsAllLoopsWhosePiecesAreThreeConnected) {
  std::vector<CellGraph> graphs = {test::cube(), test::prism(5), test::bipyramid(4), test::pyramid(5)};
  for (std::uint32_t seed = 0; seed < 8; ++seed)
    graphs.push_back(
        test::random_map(seed, 8, seed % 2 ? test::RandomKind::mixed : test::RandomKind::simple));
  for (const CellGraph& graph : graphs) {
    const CellIncidence incidence(graph);
    std::size_t valid = 0;
    try_all(graph, vertices_of(graph), 6, [&](const CuttingLoop& loop) {
      const bool by_rule = !why_invalid(graph, incidence, loop);
      ASSERT_EQ(by_rule, cuts_well(graph, loop));
      valid += by_rule;
    });
    EXPECT_EQ(valid_loops(graph, up_to(6)).loops.size(), valid);
  }
}

TEST(LoopEnumeration, FindsLoopsThroughNewVertices) {
  const CellGraph graph = test::cube();
  const std::vector<EdgeId> split = {edge(graph, 0, 4), edge(graph, 1, 5), edge(graph, 2, 6),
                                     edge(graph, 3, 7), edge(graph, 0, 1)};
  const LoopList found = valid_loops(graph, up_to(5, split));
  std::set<CuttingLoop> distinct(found.loops.begin(), found.loops.end());
  EXPECT_EQ(distinct.size(), found.loops.size());
  for (const CuttingLoop& loop : found.loops) EXPECT_TRUE(cuts_well(graph, loop));
  const auto around = std::find_if(found.loops.begin(), found.loops.end(),
                                   [](const CuttingLoop& loop) { return loop.auxiliary_vertices() == 4; });
  ASSERT_NE(around, found.loops.end());
  std::vector<LoopPlace> places = vertices_of(graph);
  for (const EdgeId id : split) places.push_back(LoopPlace::inside(id));
  const CellIncidence incidence(graph);
  std::size_t valid = 0;
  try_all(graph, vertices_of(graph), 5, [&](const CuttingLoop& loop) { valid += cuts_well(graph, loop); });
  EXPECT_EQ(valid + static_cast<std::size_t>(
                        std::count_if(found.loops.begin(), found.loops.end(),
                                      [](const CuttingLoop& loop) { return loop.auxiliary_vertices() > 0; })),
            found.loops.size());
}

TEST(LoopEnumeration, LoopsThroughAnEdgeAreThoseOfAllThatPassIt) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const CellGraph graph = test::random_map(seed, 14, test::RandomKind::simple);
    const LoopList all = valid_loops(graph);
    for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
      const auto passes = [&](const CuttingLoop& loop) {
        return std::find(loop.steps.begin(), loop.steps.end(), LoopStep::along(EdgeId(e))) !=
               loop.steps.end();
      };
      const LoopList through = valid_loops_through(graph, EdgeId(e));
      EXPECT_EQ(static_cast<std::ptrdiff_t>(through.loops.size()),
                std::count_if(all.loops.begin(), all.loops.end(), passes));
      EXPECT_TRUE(std::all_of(through.loops.begin(), through.loops.end(), passes));
    }
  }
}

TEST(LoopEnumeration, StopsWhereToldAndSaysSo) {
  LoopOptions few;
  few.max_loops = 13;
  EXPECT_EQ(valid_loops(test::cube(), few).loops.size(), 13u);
  EXPECT_FALSE(valid_loops(test::cube(), few).complete);
  few.max_loops = 14;
  EXPECT_TRUE(valid_loops(test::cube(), few).complete);
  few.max_loops = 0;
  EXPECT_ERROR(valid_loops(test::cube(), few), ErrorCode::invalid_argument, "max_loops");
  EXPECT_ERROR(valid_loops(test::cube(), up_to(2)), ErrorCode::invalid_argument, "max_length");
  EXPECT_ERROR(valid_loops(with_vertex_on_edge(test::cube(), EdgeId(0)).graph),
               ErrorCode::not_three_connected, "3-connected");
}

TEST(ImpedingEdges, NeedANewVertexInTheHollowPyramid) {
  const CellGraph graph = test::hollow_pyramid();
  for (int v = 0; v < 3; ++v) {
    const EdgeId concave = edge(graph, v, 3), opposite = edge(graph, (v + 1) % 3, (v + 2) % 3);
    EXPECT_EQ(impeding_edges(graph, concave), std::vector{opposite});
    EXPECT_TRUE(valid_loops_through(graph, concave, up_to(100)).loops.empty());
    const LoopList loops = valid_loops_through(graph, concave, up_to(100, {opposite}));
    ASSERT_EQ(loops.loops.size(), 1u);
    EXPECT_EQ(loops.loops[0].length(), 4);
    EXPECT_EQ(loops.loops[0].auxiliary_vertices(), 1);
  }
}

// Theorem 2, on every edge of random maps.
TEST(ImpedingEdges, WithVerticesOnThemThereIsALoopThroughEveryEdge) {
  int needed = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const CellGraph graph =
        test::random_map(seed, 10, seed % 2 ? test::RandomKind::mixed : test::RandomKind::simple);
    for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
      EXPECT_FALSE(
          valid_loops_through(graph, EdgeId(e), up_to(20, impeding_edges(graph, EdgeId(e)))).loops.empty());
      needed += valid_loops_through(graph, EdgeId(e), up_to(20)).loops.empty();
    }
  }
  EXPECT_GT(needed, 10);
}

TEST(ExtendingLoops, ContinueAWallOfAnLShape) {
  const CellGraph graph = test::l_shape();
  const LoopList loops = extending_loops(graph, FaceId(2), up_to(8, {edge(graph, 5, 0), edge(graph, 11, 6)}));
  const auto straight = std::find_if(loops.loops.begin(), loops.loops.end(),
                                     [](const CuttingLoop& loop) { return loop.auxiliary_vertices() == 2; });
  ASSERT_NE(straight, loops.loops.end());
  EXPECT_EQ(straight->length(), 4);
  EXPECT_TRUE(straight->extends());
  EXPECT_TRUE(extending_loops(graph, FaceId(0), up_to(8)).loops.empty());  // has no edge that is not convex
}

TEST(ExtendingLoops, OfNoFaceAreRefused) {
  EXPECT_ERROR(extending_loops(test::cube(), FaceId(6)), ErrorCode::invalid_argument, "no face 6");
  EXPECT_ERROR(valid_loops(test::cube(), up_to(4, {EdgeId(12)})), ErrorCode::invalid_argument, "edge 12");
}

TEST(ExtendingLoops, ContinueTheFloorOfANotchThroughTwoEdges) {
  const CellGraph graph = test::notched_cube();
  const std::vector<EdgeId> uprights = {edge(graph, 0, 4), edge(graph, 1, 5), edge(graph, 2, 6)};
  const LoopList loops = extending_loops(graph, FaceId(6), up_to(6, uprights));
  const auto floor = std::find_if(loops.loops.begin(), loops.loops.end(),
                                  [](const CuttingLoop& loop) { return loop.auxiliary_vertices() == 3; });
  ASSERT_NE(floor, loops.loops.end());
  const CellIncidence incidence(graph);
  EXPECT_FALSE(why_invalid(graph, incidence, *floor));
  CuttingLoop without = *floor;
  for (LoopStep& step : without.steps) step.extension = Extension::none;
  EXPECT_TRUE(why_invalid(graph, incidence, without));  // three places on the floor
}

TEST(ConstructiveLoop, IsThereInEveryCellButTheTetrahedron) {
  EXPECT_ERROR(constructive_loop(test::pyramid(3)), ErrorCode::unsupported, "tetrahedron");
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const CellGraph graph = test::random_map(seed, 5 + static_cast<int>(seed % 20),
                                             seed % 2 ? test::RandomKind::mixed : test::RandomKind::simple);
    if (graph.vertex_count == 4) continue;
    EXPECT_TRUE(cuts_well(graph, constructive_loop(graph))) << seed;
  }
}

// Where all degrees are four or more, neighbours of a vertex may share a face or not.
TEST(ConstructiveLoop, IsThereWhereNoVertexHasThreeEdges) {
  for (int n = 4; n < 8; ++n)
    EXPECT_TRUE(cuts_well(test::bipyramid(n), constructive_loop(test::bipyramid(n))));
}

TEST(CuttingLoop, HasOneNormalFormWhateverItsStartAndDirection) {
  const CellGraph graph = test::l_shape();
  CuttingLoop loop =
      loop_through(graph, CellIncidence(graph),
                   {LoopPlace::at(VertexId(3)), LoopPlace::at(VertexId(9)),
                    LoopPlace::inside(edge(graph, 11, 6)), LoopPlace::inside(edge(graph, 5, 0))});
  loop.steps[0].extension = Extension::left;
  CuttingLoop other = loop_through(graph, CellIncidence(graph),
                                   {LoopPlace::inside(edge(graph, 11, 6)), LoopPlace::at(VertexId(9)),
                                    LoopPlace::at(VertexId(3)), LoopPlace::inside(edge(graph, 5, 0))});
  other.steps[1].extension = Extension::right;
  EXPECT_EQ(normal_form(loop), normal_form(other));
  EXPECT_EQ(normal_form(normal_form(loop)), normal_form(loop));
  EXPECT_FALSE(why_invalid(graph, CellIncidence(graph), normal_form(loop)));
  other.steps[1].extension = Extension::left;
  EXPECT_NE(normal_form(loop), normal_form(other));
}

TEST(LoopValidity, SaysWhatIsWrong) {
  const CellGraph cube = test::cube();
  const CellIncidence incidence(cube);
  const auto at = [](std::initializer_list<int> vertices) {
    std::vector<LoopPlace> places;
    for (const int v : vertices) places.push_back(LoopPlace::at(VertexId(v)));
    return places;
  };
  const auto fault = [&](const CuttingLoop& loop) {
    return why_invalid(cube, incidence, loop).value_or("valid");
  };
  EXPECT_EQ(fault(loop_through(cube, incidence, at({0, 2, 5}))), "valid");
  EXPECT_NE(fault(loop_through(cube, incidence, at({0, 1, 2}))).find("two are the most"), std::string::npos);
  EXPECT_NE(fault(loop_through(cube, incidence, at({0, 1, 2, 6, 4}))).find("two are the most"),
            std::string::npos);
  CuttingLoop loop = loop_through(cube, incidence, at({0, 2, 6, 4}));
  EXPECT_EQ(fault(loop), "valid");
  loop.steps[1].extension = Extension::left;
  EXPECT_NE(fault(loop).find("which is convex"), std::string::npos);
  loop.steps[1] = LoopStep::along(EdgeId(0));
  EXPECT_NE(fault(loop).find("does not join"), std::string::npos);
  loop.steps[1] = LoopStep::across(FaceId(5));
  EXPECT_NE(fault(loop).find("does not lie"), std::string::npos);
  EXPECT_ERROR(loop_through(cube, incidence, at({0, 6, 1})), ErrorCode::invalid_argument, "share 0 faces");
  EXPECT_ERROR(loop_through(cube, incidence, at({0, 9, 1})), ErrorCode::invalid_argument, "vertex 9");
}

}  // namespace
}  // namespace isopatch::segmentation
