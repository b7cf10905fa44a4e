#include "geometry/brep/hexahedra_quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

constexpr std::array<std::array<int, 4>, 6> loops = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// A hexahedron whose corners go around the bottom and then around the top, with straight edges. Each edge
/// runs from its lower corner on.
CellComplex hexahedron(const Eigen::Matrix<double, 3, 8>& corners) {
  CellComplex complex;
  for (const auto& corner : corners.colwise()) complex.vertices.emplace_back(corner);
  const auto use_between = [&](int from, int to) {
    const VertexId low(std::min(from, to)), high(std::max(from, to));
    for (std::size_t e = 0; e < complex.edges.size(); ++e)
      if (complex.edges[e].start == low && complex.edges[e].end == high)
        return EdgeUse{EdgeId(static_cast<int>(e)), from > to};
    return EdgeUse{complex.add_straight_edge(low, high), from > to};
  };
  Cell cell;
  for (const auto& corner : loops) {
    CellFace face{SurfaceId(0), {}, {}};
    for (std::size_t i = 0; i < 4; ++i) face.loop.push_back(use_between(corner[i], corner[(i + 1) % 4]));
    cell.faces.push_back({complex.add_face(std::move(face)), false, static_cast<int>(cell.faces.size())});
  }
  complex.cells.push_back(std::move(cell));
  return complex;
}

Eigen::Matrix<double, 3, 8> cube_corners() {
  Eigen::Matrix<double, 3, 8> corners;
  corners << 0, 1, 1, 0, 0, 1, 1, 0,  //
      0, 0, 1, 1, 0, 0, 1, 1,         //
      0, 0, 0, 0, 1, 1, 1, 1;
  return corners;
}

CellEdge& edge_of(CellComplex& complex, int low, int high) {
  return *std::find_if(complex.edges.begin(), complex.edges.end(), [&](const CellEdge& edge) {
    return edge.start == VertexId(low) && edge.end == VertexId(high);
  });
}

TEST(HexahedraQuality, OfBricksIsOne) {
  EXPECT_NEAR(least_quality(hexahedron(cube_corners())), 1, 1e-14);
  const Eigen::Vector3d sides(3, 0.1, 7);
  EXPECT_NEAR(least_quality(hexahedron(sides.asDiagonal() * cube_corners())), 1, 1e-14);
}

TEST(HexahedraQuality, OfAParallelepipedIsItsVolumeOverItsEdges) {
  Eigen::Matrix3d map;
  map << 1, 0.2, 0.7, 0, 1.5, -0.4, 0.1, 0.3, 0.9;
  const double expected = map.determinant() / (map.col(0).norm() * map.col(1).norm() * map.col(2).norm());
  EXPECT_NEAR(least_quality(hexahedron(map * cube_corners())), expected, 1e-14);
  // Whichever way its first face looks.
  const Eigen::DiagonalMatrix<double, 3> mirror(1, 1, -1);
  EXPECT_NEAR(least_quality(hexahedron(mirror * map * cube_corners())), expected, 1e-14);
}

TEST(HexahedraQuality, SeesFoldsOfCornersAndOfEdgesAlone) {
  Eigen::Matrix<double, 3, 8> pulled_through = cube_corners();
  pulled_through.col(6) << 0.2, 0.2, -0.5;
  EXPECT_LT(least_quality(hexahedron(pulled_through)), 0);
  // Corners of a cube, and an edge of its top that passes below the bottom.
  CellComplex sagging = hexahedron(cube_corners());
  Eigen::Matrix3Xd points(3, 3);
  points << 0, 0.5, 1, 0, 0, 0, 1, -3, 1;
  sagging.curves[static_cast<std::size_t>(edge_of(sagging, 4, 5).curve.value)].shape =
      NurbsCurve({KnotVector::bezier(2)}, points);
  EXPECT_LT(least_quality(sagging), 0);
}

TEST(HexahedraQuality, TakesEdgesForThePiecesThatTheyAre) {
  // Two edges run the other way, and one is the middle half of a longer segment.
  CellComplex brick = hexahedron(cube_corners());
  CellEdge& piece = edge_of(brick, 4, 5);
  brick.curves[static_cast<std::size_t>(piece.curve.value)].shape = segment({-0.5, 0, 1}, {1.5, 0, 1});
  piece.low = 0.25;
  piece.high = 0.75;
  for (const auto& [low, high] : {std::pair(0, 4), std::pair(2, 3)}) {
    CellEdge& turned = edge_of(brick, low, high);
    const EdgeId id(static_cast<int>(&turned - brick.edges.data()));
    std::swap(turned.start, turned.end);
    auto& curve = std::get<NurbsCurve>(brick.curves[static_cast<std::size_t>(turned.curve.value)].shape);
    curve = reversed(curve, 0);
    for (CellFace& face : brick.faces)
      for (EdgeUse& use : face.loop)
        if (use.edge == id) use.reversed = !use.reversed;
  }
  EXPECT_NEAR(least_quality(brick), 1, 1e-14);
}

TEST(HexahedraQuality, IsThatOfTheWorstCell) {
  Eigen::Matrix<double, 3, 8> sheared = cube_corners();
  sheared.row(0) += 2 * sheared.row(2);
  CellComplex two = hexahedron(cube_corners());
  const CellComplex other = hexahedron(sheared);
  const auto shift = [](auto& id, std::size_t by) { id.value += static_cast<int>(by); };
  for (CellEdge edge : other.edges) {
    shift(edge.curve, two.curves.size());
    shift(edge.start, two.vertices.size());
    shift(edge.end, two.vertices.size());
    two.edges.push_back(edge);
  }
  for (CellFace face : other.faces) {
    for (EdgeUse& use : face.loop) shift(use.edge, other.edges.size());
    two.faces.push_back(face);
  }
  Cell second = other.cells[0];
  for (CellFaceUse& use : second.faces) shift(use.face, other.faces.size());
  two.cells.insert(two.cells.begin(), second);
  two.curves.insert(two.curves.end(), other.curves.begin(), other.curves.end());
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  EXPECT_NEAR(least_quality(two), 1 / std::sqrt(5), 1e-14);
}

}  // namespace
}  // namespace isopatch::geometry
