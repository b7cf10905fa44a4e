#include "geometry/topology/planar_drawing.hpp"

#include <fmt/format.h>

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/sparse_lu.hpp"

namespace isopatch::geometry {
namespace {

FaceId largest_face(const EdgeGraph& graph) {
  const auto found = std::max_element(
      graph.faces.begin(), graph.faces.end(),
      [](const auto& a, const auto& b) { return a.loops.front().size() < b.loops.front().size(); });
  return FaceId(static_cast<int>(found - graph.faces.begin()));
}

}  // namespace

Eigen::Matrix2Xd planar_drawing(const EdgeGraph& graph, const ConnectivityReport& report,
                                const PlanarDrawingOptions& options) {
  if (!report.three_connected)
    throw Error(ErrorCode::not_three_connected,
                "only the edge graph of a ball whose graph is 3-connected has a drawing with straight edges");
  const FaceId outer = options.outer.value_or(largest_face(graph));
  if (outer.value < 0 || static_cast<std::size_t>(outer.value) >= graph.faces.size())
    throw Error(ErrorCode::invalid_argument, fmt::format("there is no face {}", outer.value));
  const std::vector<VertexId> rim = corners(graph, graph.face(outer).loops.front());

  Eigen::Matrix2Xd positions = Eigen::Matrix2Xd::Zero(2, graph.vertex_count);
  std::vector<int> unknown(static_cast<std::size_t>(graph.vertex_count), 0);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double angle =
        std::numbers::pi * (0.5 + (2.0 * static_cast<double>(i) + 1) / static_cast<double>(rim.size()));
    positions.col(rim[i].value) << std::cos(angle), std::sin(angle);
    unknown[static_cast<std::size_t>(rim[i].value)] = -1;
  }
  int count = 0;
  for (int& number : unknown)
    if (number == 0) number = count++;
  if (count == 0) return positions;

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
  const auto add = [&](VertexId vertex, VertexId neighbour) {
    const int row = unknown[static_cast<std::size_t>(vertex.value)];
    const int column = unknown[static_cast<std::size_t>(neighbour.value)];
    if (row < 0) return;
    entries.emplace_back(row, row, 1);
    if (column >= 0)
      entries.emplace_back(row, column, -1);
    else
      right.row(row) += positions.col(neighbour.value).transpose();
  };
  for (const EdgeGraph::Edge& edge : graph.edges) {
    add(edge.start, edge.end);
    add(edge.end, edge.start);
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixX2d solution = solve_by_lu(matrix, right).value();
  for (std::size_t v = 0; v < unknown.size(); ++v)
    if (unknown[v] >= 0) positions.col(static_cast<Eigen::Index>(v)) = solution.row(unknown[v]).transpose();
  return positions;
}

}  // namespace isopatch::geometry
