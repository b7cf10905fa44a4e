#include "segmentation/decomposition/combinatorics/decomposition_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"
#include "segmentation/decomposition/combinatorics/refinement.hpp"
#include "segmentation/decomposition/combinatorics/tests/definitions.hpp"
#include "segmentation/decomposition/combinatorics/tests/random_graphs.hpp"
#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::segmentation {
namespace {

SearchCell cell_of(const CellGraph& graph) {
  SearchCell cell;
  cell.graph = graph;
  return cell;
}

CellGraph all_convex(CellGraph graph) {
  for (CellGraph::Edge& edge : graph.edges) edge.kind = EdgeKind::convex;
  return graph;
}

CutTree search(const CellGraph& graph, const SearchOptions& options = {}) {
  return search_cuts(cell_of(graph), combinatorial_oracle(), options);
}

// The tree hangs together, and its leaves are what the sums say.
void check_tree(const CutTree& tree) {
  ASSERT_TRUE(tree.complete());
  std::vector<int> parents(tree.nodes.size());
  int hexahedra = 0;
  for (const CutTree::Node& node : tree.nodes) {
    ASSERT_TRUE(test::three_connected_by_definition(node.cell.graph));
    ASSERT_EQ(node.loop.has_value(), !node.pieces.empty());
    ASSERT_NE(node.base.has_value(), node.loop.has_value());
    for (const int piece : node.pieces) ++parents[static_cast<std::size_t>(piece)];
    if (!node.base) continue;
    ASSERT_EQ(non_convex_count(node.cell.graph), 0);
    hexahedra += template_hexahedra(node.base->kind, node.base->sides);
  }
  EXPECT_EQ(parents[0], 0);
  EXPECT_EQ(std::count(parents.begin() + 1, parents.end(), 1),
            static_cast<std::ptrdiff_t>(parents.size()) - 1);
  EXPECT_EQ(tree.hexahedra, hexahedra);
}

TEST(DecompositionSearch, LeavesBaseSolidsAsTheyAre) {
  const CutTree tree = search(test::prism(5));
  EXPECT_EQ(tree.nodes.size(), 1u);
  EXPECT_EQ(tree.hexahedra, 4);
  EXPECT_EQ(tree.evaluations, 0);
}

TEST(DecompositionSearch, CutsLShapesIntoTwoHexahedra) {
  for (const CellGraph& graph : {test::l_shape(), test::cut_l_shape()}) {
    const CutTree tree = search(graph);
    check_tree(tree);
    EXPECT_EQ(tree.hexahedra, 2);
    EXPECT_EQ(tree.nodes.size(), 3u);
  }
}

TEST(DecompositionSearch, CutsTheNotchedCube) {
  const CutTree tree = search(test::notched_cube());
  check_tree(tree);
  EXPECT_EQ(tree.hexahedra, 3);
}

TEST(DecompositionSearch, CutsTheHollowPyramidThoughItNeedsNewVertices) {
  const CutTree tree = search(test::hollow_pyramid());
  check_tree(tree);
}

TEST(DecompositionSearch, CutsTheScienceParkIntoNineHexahedraOrFewer) {
  const CutTree convex = search(all_convex(test::science_park()));
  check_tree(convex);
  EXPECT_LE(convex.hexahedra, 9);
  SearchOptions narrow;
  narrow.beam = narrow.branches = 2;
  const CutTree kinds = search(test::science_park(), narrow);
  check_tree(kinds);
  EXPECT_LE(kinds.hexahedra, 9);
}

TEST(DecompositionSearch, CutsSixtyVerticesIntoFewerThanAHundredHexahedra) {
  SearchOptions options;
  options.beam = 4;
  options.branches = 2;
  const CutTree tree = search(test::random_map(1, 60, test::RandomKind::simple), options);
  check_tree(tree);
  EXPECT_LE(tree.hexahedra, 99);
}

TEST(DecompositionSearch, IsTheLeastForSmallCells) {
  HexahedraCount count;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const CellGraph graph = test::random_map(seed, 9, test::RandomKind::mixed);
    SearchOptions options;
    options.cost = {};
    options.cost.length = options.cost.auxiliary_edge = options.cost.face_size = options.cost.t_joint = 0;
    const CutTree tree = search(graph, options);
    check_tree(tree);
    EXPECT_EQ(tree.hexahedra, count.minimum(graph)) << seed;
  }
}

TEST(DecompositionSearch, AWiderBeamIsNoWorse) {
  SearchOptions narrow, wide;
  narrow.beam = narrow.branches = 1;
  wide.beam = 4;
  double costs[2] = {0, 0};
  for (std::uint32_t seed = 0; seed < 3; ++seed) {
    const CellGraph graph = test::random_map(seed, 20, test::RandomKind::simple);
    costs[0] += search(graph, narrow).cost;
    costs[1] += search(graph, wide).cost;
  }
  EXPECT_LT(costs[1], costs[0]);
}

TEST(DecompositionSearch, GivesTheSameTreeEveryTime) {
  const CellGraph graph = test::random_map(5, 16, test::RandomKind::mixed);
  const CutTree one = search(graph), other = search(graph);
  ASSERT_EQ(one.nodes.size(), other.nodes.size());
  for (std::size_t k = 0; k < one.nodes.size(); ++k)
    EXPECT_EQ(one.nodes[k].cell.graph, other.nodes[k].cell.graph);
}

TEST(DecompositionSearch, FinishesAfterItsBudget) {
  SearchOptions options;
  options.evaluations = 1;
  const CellGraph graph = test::random_map(2, 18, test::RandomKind::simple);
  const CutTree tree = search(graph, options);
  check_tree(tree);
  EXPECT_LT(tree.evaluations, search(graph).evaluations);
}

TEST(DecompositionSearch, EndsWithWhatItHasWhenItIsToldTo) {
  SearchOracle oracle = combinatorial_oracle();
  std::vector<int> cuts;
  oracle.goes_on = [&](const SearchRound& round) {
    EXPECT_GT(round.open, 0);
    cuts.push_back(round.cuts);
    return cuts.size() < 3;
  };
  const CutTree tree = search_cuts(cell_of(test::random_map(2, 18, test::RandomKind::simple)), oracle);
  EXPECT_EQ(cuts, (std::vector<int>{0, 1, 2}));
  EXPECT_FALSE(tree.complete());
  EXPECT_EQ(std::count_if(tree.nodes.begin(), tree.nodes.end(), [](const auto& node) { return node.loop; }),
            2);
}

TEST(DecompositionSearch, SimpleAndConvexSolidsMayStay) {
  SearchOracle oracle = combinatorial_oracle();
  SearchOptions options;
  const SearchCell prism = cell_of(test::prism(6)), pyramid = cell_of(test::pyramid(5));
  options.finish = Finish::simple_solids;
  // Nobody has accepted them.
  EXPECT_EQ(search_cuts(prism, oracle, options).nodes.size(), 1U);  // a prism is a base solid
  oracle.accepts = [](const SearchCell& cell, const BaseSolid& base) {
    return non_convex_count(cell.graph) == 0 && base.kind != BaseKind::prism &&
           base.kind != BaseKind::pyramid;
  };
  const CutTree stays = search_cuts(prism, oracle, options);
  ASSERT_EQ(stays.nodes.size(), 1U);
  EXPECT_EQ(stays.nodes[0].base->kind, BaseKind::simple);
  EXPECT_EQ(stays.hexahedra, 12);
  options.finish = Finish::base_solids;
  EXPECT_EQ(search_cuts(prism, oracle, options).hexahedra, 2);
  EXPECT_GT(search_cuts(pyramid, oracle, options).nodes.size(), 1U);
  options.finish = Finish::convex_solids;
  const CutTree convex = search_cuts(pyramid, oracle, options);
  ASSERT_EQ(convex.nodes.size(), 1U);
  EXPECT_EQ(convex.nodes[0].base->kind, BaseKind::convex);
  EXPECT_EQ(convex.nodes[0].base->sides, 5 + 5);  // five triangles, and as many around the middle of the base
  // Concave edges are cut through all the same.
  EXPECT_EQ(search_cuts(cell_of(test::l_shape()), oracle, options).nodes.size(), 3U);
}

TEST(DecompositionSearch, HandsBackSeveralWaysCheapestFirst) {
  SearchOptions options;
  options.alternatives = 5;
  const std::vector<CutTree> ways = search_several(cell_of(test::l_shape()), combinatorial_oracle(), options);
  ASSERT_GT(ways.size(), 1U);
  EXPECT_LE(ways.size(), 5U);
  for (const CutTree& way : ways) check_tree(way);
  for (std::size_t k = 1; k < ways.size(); ++k) EXPECT_LE(ways[k - 1].cost, ways[k].cost);
  EXPECT_EQ(ways[0].hexahedra, search(test::l_shape()).hexahedra);
}

TEST(DecompositionSearch, ChargesSolidsThatAreNoHexahedra) {
  SearchOptions options;
  const double plain = search(test::pyramid(3), options).cost;
  options.cost.divided = 3;
  EXPECT_DOUBLE_EQ(search(test::pyramid(3), options).cost, plain + 3);
  EXPECT_DOUBLE_EQ(search(test::cube(), options).cost, 1);
}

TEST(DecompositionSearch, TakesNoForAnAnswer) {
  SearchOracle oracle = combinatorial_oracle();
  const auto cut = oracle.cut;
  oracle.cut = [cut](const SearchCell& cell, const CuttingLoop& loop) {
    if (loop.extends() || loop.length() == 4) return CutAnswer{{}, "I like no loops of four", 0};
    return cut(cell, loop);
  };
  SearchOptions options;
  options.refusals = 1000;
  options.beam = options.branches = 2;
  const CutTree tree = search_cuts(cell_of(test::science_park()), oracle, options);
  check_tree(tree);
  EXPECT_GT(tree.refusals, 0);
  for (const CutTree::Node& node : tree.nodes) EXPECT_FALSE(node.loop && node.loop->length() == 4);
}

TEST(DecompositionSearch, LeavesWhatCannotBeCut) {
  SearchOracle oracle;
  int asked = 0;
  oracle.cut = [&](const SearchCell&, const CuttingLoop&) {
    ++asked;
    return CutAnswer{{}, "never", 0};
  };
  const CutTree tree = search_cuts(cell_of(test::l_shape()), oracle);
  EXPECT_FALSE(tree.complete());
  EXPECT_EQ(tree.unfinished, std::vector{0});
  EXPECT_EQ(tree.hexahedra, 0);
  EXPECT_EQ(tree.refusals, asked);
  EXPECT_GT(asked, 10);
  EXPECT_LE(asked, SearchOptions{}.refusals);
}

TEST(DecompositionSearch, RefusesPiecesThatAreNot3Connected) {
  SearchOracle oracle;
  oracle.cut = [](const SearchCell&, const CuttingLoop&) {
    return CutAnswer{
        {cell_of(test::cube()), cell_of(with_vertex_on_edge(test::cube(), EdgeId(0)).graph)}, "", 0};
  };
  EXPECT_FALSE(search_cuts(cell_of(test::l_shape()), oracle).complete());
}

TEST(DecompositionSearch, AsksOnceForACutOfACell) {
  SearchOracle oracle = combinatorial_oracle();
  const auto cut = oracle.cut;
  int handles = 0;
  std::set<std::pair<int, CuttingLoop>> asked;
  oracle.cut = [&](const SearchCell& cell, const CuttingLoop& loop) {
    EXPECT_TRUE(asked.emplace(cell.handle, normal_form(loop)).second);
    if (loop.length() == 4) return CutAnswer{{}, "so that other stages come too", 0};
    CutAnswer answer = cut(cell, loop);
    for (SearchCell& piece : answer.pieces) piece.handle = ++handles;
    return answer;
  };
  SearchCell whole = cell_of(test::science_park());
  whole.handle = 0;
  SearchOptions narrow;
  narrow.beam = narrow.branches = 3;
  const CutTree tree = search_cuts(whole, oracle, narrow);
  EXPECT_EQ(static_cast<int>(asked.size()), tree.evaluations);
  std::set<int> used;
  for (const CutTree::Node& node : tree.nodes) EXPECT_TRUE(used.insert(node.cell.handle).second);
}

TEST(DecompositionSearch, TakesWhatIsProposed) {
  // Three slabs of a heptagonal prism that the enumeration does not know: through the middles of its
  // uprights.
  const CellGraph graph = all_convex(test::science_park());
  const CellIncidence incidence(graph);
  std::vector<LoopPlace> places;
  for (const auto& [a, b] :
       {std::pair(4, 13), {5, 14}, {6, 15}, {7, 16}, {8, 18}, {9, 20}, {10, 21}, {11, 22}})
    places.push_back(LoopPlace::inside(*edge_between(graph, VertexId(a), VertexId(b))));
  const CuttingLoop proposal = loop_through(graph, incidence, places);
  SearchOracle oracle = combinatorial_oracle();
  const auto cut = oracle.cut;
  oracle.propose = [&](const SearchCell& cell) {
    return cell.graph == graph ? std::vector{proposal} : std::vector<CuttingLoop>{};
  };
  oracle.cut = [&](const SearchCell& cell, const CuttingLoop& loop) {
    if (cell.graph == graph && loop != proposal) return CutAnswer{{}, "not what was proposed", 0};
    return cut(cell, loop);
  };
  SearchOptions options;
  options.refusals = 1000;
  const CutTree tree = search_cuts(cell_of(graph), oracle, options);
  check_tree(tree);
  EXPECT_EQ(tree.nodes[0].loop, proposal);
}

TEST(DecompositionSearch, CutsBaseSolidsThatAreNotAccepted) {
  SearchOracle oracle = combinatorial_oracle();
  oracle.accepts = [](const SearchCell&, const BaseSolid& solid) {
    return solid.kind != BaseKind::pyramid && (solid.kind != BaseKind::prism || solid.sides == 3);
  };
  const CutTree tree = search_cuts(cell_of(test::pyramid(5)), oracle);
  check_tree(tree);
  EXPECT_EQ(tree.hexahedra, 12);
  EXPECT_GT(tree.nodes.size(), 1u);
}

TEST(DecompositionSearch, RefusesCellsThatTwoVerticesTakeApart) {
  EXPECT_ERROR(search(with_vertex_on_edge(test::cube(), EdgeId(0)).graph), ErrorCode::not_three_connected,
               "3-connected");
}

TEST(DecompositionSearch, NeedsAnOracle) {
  EXPECT_ERROR(search_cuts(cell_of(test::cube()), {}), ErrorCode::invalid_argument, "SearchOracle::cut");
}

TEST(CombinatorialOracle, CarriesPointsAndNeighbours) {
  SearchCell cell = cell_of(test::l_shape());
  cell.geometry.points = test::l_shape_points();
  const auto middle = [&](int a, int b) {
    return LoopPlace::inside(*edge_between(cell.graph, VertexId(a), VertexId(b)));
  };
  CuttingLoop loop =
      loop_through(cell.graph, CellIncidence(cell.graph),
                   {LoopPlace::at(VertexId(3)), LoopPlace::at(VertexId(9)), middle(11, 6), middle(5, 0)});
  loop.steps[0].extension = Extension::left;
  const CutAnswer answer = combinatorial_oracle().cut(cell, loop);
  ASSERT_EQ(answer.pieces.size(), 2u);
  for (const SearchCell& piece : answer.pieces) {
    EXPECT_EQ(piece.geometry.points.cols(), 8);
    EXPECT_EQ(std::count(piece.geometry.has_neighbour.begin(), piece.geometry.has_neighbour.end(), true), 1);
  }
  EXPECT_EQ(answer.pieces[0].geometry.points.row(1).maxCoeff<Eigen::PropagateNaN>(), 1);
  EXPECT_EQ(answer.pieces[1].geometry.points.row(1).minCoeff<Eigen::PropagateNaN>(), 1);
}

TEST(SearchOptions, NamesWhatIsOutOfRange) {
  SearchOptions options;
  options.beam = 0;
  EXPECT_ERROR(validate(options), ErrorCode::invalid_argument, "SearchOptions::beam is 0");
  options = {};
  options.max_length = 2;
  EXPECT_ERROR(search(test::cube(), options), ErrorCode::invalid_argument, "max_length");
}

}  // namespace
}  // namespace isopatch::segmentation
