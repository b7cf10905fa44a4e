#pragma once

#include <Eigen/Core>
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

/// An L with one leg pointed below: 11 vertices; edge 4 - 5 is not convex.
inline CellGraph pointed_l_shape() {
  return with_kind(cell_graph(11, {{0, 3, 2, 1},
                                   {0, 1, 8},
                                   {1, 2, 6, 5, 9, 8},
                                   {2, 3, 7, 6},
                                   {0, 8, 10, 4, 7, 3},
                                   {5, 4, 10, 9},
                                   {8, 9, 10},
                                   {4, 5, 6, 7}}),
                   {{4, 5}}, EdgeKind::non_convex);
}

/// Two tetrahedra on one base 0, 1, 2, the one with apex 3 inside that with apex 4: the edges at 3 are not
/// convex.
inline CellGraph hollow_pyramid() {
  return with_kind(cell_graph(5, {{0, 3, 1}, {1, 3, 2}, {0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {0, 4, 2}}),
                   {{0, 3}, {1, 3}, {2, 3}}, EdgeKind::non_convex);
}

/// An L, the prism over (0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2): bottom 0 .. 5, top 6 .. 11.
inline CellGraph l_shape() {
  return with_kind(prism(6), {{3, 9}}, EdgeKind::non_convex);
}

inline Eigen::Matrix3Xd l_shape_points() {
  Eigen::Matrix3Xd points(3, 12);
  points << 0, 2, 2, 1, 1, 0, 0, 2, 2, 1, 1, 0,  //
      0, 0, 1, 1, 2, 2, 0, 0, 1, 1, 2, 2,        //
      0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1;
  return points;
}

/// The cube [0, 2]^3 without [1, 2]^3. 0 .. 6: its corners but (2, 2, 2), x fastest; 7: (1, 1, 1); 8, 9, 10:
/// from there along x, y, z; 11, 12, 13: (1, 2, 2), (2, 1, 2), (2, 2, 1). Face 6 is the floor of the notch.
inline CellGraph notched_cube() {
  return with_kind(cell_graph(14, {{0, 2, 3, 1},
                                   {0, 1, 5, 4},
                                   {0, 4, 6, 2},
                                   {1, 3, 13, 8, 12, 5},
                                   {2, 6, 11, 9, 13, 3},
                                   {4, 5, 12, 10, 11, 6},
                                   {7, 8, 13, 9},
                                   {7, 10, 12, 8},
                                   {7, 9, 11, 10}}),
                   {{7, 8}, {7, 9}, {7, 10}}, EdgeKind::non_convex);
}

}  // namespace isopatch::segmentation::test
