#pragma once

#include <utility>
#include <vector>

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

namespace isopatch::segmentation::test {

/// Bottom 0 .. n - 1, top n .. 2 n - 1; faces: the n walls, the bottom, the top.
inline CellGraph prism(int n) {
  std::vector<std::vector<int>> faces;
  std::vector<int> bottom, top;
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    faces.push_back({k, next, n + next, n + k});
    bottom.insert(bottom.begin(), k);
    top.push_back(n + k);
  }
  faces.push_back(bottom);
  faces.push_back(top);
  return cell_graph(2 * n, faces);
}

inline CellGraph cube() {
  return prism(4);
}

/// Base 0 .. n - 1, apex n; faces: the walls, the base.
inline CellGraph pyramid(int n) {
  std::vector<std::vector<int>> faces;
  std::vector<int> bottom;
  for (int k = 0; k < n; ++k) {
    faces.push_back({k, (k + 1) % n, n});
    bottom.insert(bottom.begin(), k);
  }
  faces.push_back(bottom);
  return cell_graph(n + 1, faces);
}

/// Girdle 0 .. n - 1, top n, bottom n + 1.
inline CellGraph bipyramid(int n) {
  std::vector<std::vector<int>> faces;
  for (int k = 0; k < n; ++k) {
    faces.push_back({k, (k + 1) % n, n});
    faces.push_back({(k + 1) % n, k, n + 1});
  }
  return cell_graph(n + 2, faces);
}

inline CellGraph with_kind(CellGraph graph, std::vector<std::pair<int, int>> edges, EdgeKind kind) {
  for (const auto& [a, b] : edges)
    graph.edges[static_cast<std::size_t>(edge_between(graph, VertexId(a), VertexId(b))->value)].kind = kind;
  return graph;
}

/// The Science Park's main body: a tower over a wider slab, 30 vertices. Its kinds of edges too.
inline CellGraph science_park() {
  const CellGraph graph = cell_graph(30, {{3, 2, 1, 0},           {11, 10, 9, 8, 7, 6, 5, 4},
                                          {29, 12, 1, 2},         {4, 13, 22, 11},
                                          {4, 5, 14, 13},         {5, 6, 15, 14},
                                          {6, 7, 16, 15},         {8, 18, 16, 7},
                                          {9, 20, 18, 8},         {21, 20, 9, 10},
                                          {22, 21, 10, 11},       {23, 28, 3, 0},
                                          {0, 1, 12, 13, 24, 23}, {13, 17, 25, 24},
                                          {26, 25, 17, 19},       {22, 27, 26, 19},
                                          {29, 2, 3, 28, 27, 22}, {13, 14, 15, 16, 17},
                                          {16, 18, 19, 17},       {19, 18, 20, 21, 22},
                                          {29, 22, 13, 12},       {24, 27, 28, 23},
                                          {24, 25, 26, 27}});
  return with_kind(with_kind(graph, {{13, 22}, {5, 14}, {10, 21}, {13, 17}, {17, 19}, {19, 22}, {12, 29}},
                             EdgeKind::non_convex),
                   {{13, 24}, {22, 27}, {16, 17}, {18, 19}}, EdgeKind::flat);
}

/// An L with a top that slopes towards one leg: the graph of a prism over a heptagon; edge 4 - 5 is not
/// convex.
inline CellGraph cut_l_shape() {
  return with_kind(cell_graph(14, {{3, 2, 1, 0},
                                   {1, 11, 10, 0},
                                   {2, 6, 5, 9, 12, 11, 1},
                                   {3, 7, 6, 2},
                                   {10, 13, 8, 4, 7, 3, 0},
                                   {5, 6, 7, 4},
                                   {8, 9, 5, 4},
                                   {13, 12, 9, 8},
                                   {11, 12, 13, 10}}),
                   {{4, 5}}, EdgeKind::non_convex);
}

}  // namespace isopatch::segmentation::test
