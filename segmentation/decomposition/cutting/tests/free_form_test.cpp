#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/make_brep.hpp"
#include "segmentation/decomposition/cutting/auxiliary_curve.hpp"
#include "segmentation/decomposition/cutting/cut_cell.hpp"
#include "segmentation/decomposition/cutting/inside.hpp"
#include "segmentation/decomposition/cutting/tests/sample_polyhedra.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::CellId;

TEST(BentCurve, GoesAroundACornerThatAStraightOneWouldCut) {
  const geometry::Brep l =
      geometry::make_brep(samples::prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 1));
  const CellComplex complex = geometry::one_cell(l);
  const CellShapes shapes(l, complex);
  const FaceId top(1);
  const VertexId from(8), to(10);  // (3, 1, 1) and (1, 3, 1)
  EXPECT_FALSE(auxiliary_curve(shapes, top, from, to, 1e-9));
  const auto bent = bent_curve(shapes, top, from, to, 1e-9);
  ASSERT_TRUE(bent);
  EXPECT_GT(bent->smallest_angle.degrees(), 5);
  const auto& curve = std::get<geometry::NurbsCurve>(bent->curve.shape);
  const auto at = [&](double t) { return curve.point(geometry::Parameter<1>(t)); };
  EXPECT_LT((at(0) - Eigen::Vector3d(3, 1, 1)).norm(), 1e-12);
  EXPECT_LT((at(1) - Eigen::Vector3d(1, 3, 1)).norm(), 1e-12);
  for (int i = 1; i < 40; ++i) {
    const Eigen::Vector3d p = at(i / 40.0);
    EXPECT_NEAR(p.z(), 1, 1e-9);
    EXPECT_GT(std::min(p.x(), p.y()), 0);
    EXPECT_TRUE(p.x() < 1 || p.y() < 1) << p.transpose();
  }
}

TEST(PointsInside, LieOnNoOutline) {
  // A column of the first grid of points would lie on the edge x = 1.
  Eigen::Matrix2Xd l(2, 6);
  l << 0, 2, 2, 1, 1, 0,  //
      0, 0, 1, 1, 2, 2;
  const Eigen::Matrix2Xd points = points_inside(l);
  EXPECT_GE(points.cols(), 20);
  for (const auto& point : points.colwise()) EXPECT_GT(distance_to(l, point), 1e-6);
}

TEST(CutCell, RunsThroughSixStepsInNoPlaneIfAsked) {
  std::vector<std::array<double, 2>> hexagon;
  for (int i = 0; i < 6; ++i)
    hexagon.push_back({std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3)});
  const geometry::Brep prism = geometry::make_brep(samples::prism(hexagon, 1));
  const CellComplex complex = geometry::one_cell(prism);
  const CellSides sides = cell_sides(CellShapes(prism, complex), CellId(0));
  PlacedLoop loop;
  for (int i = 0; i < 6; ++i) {
    for (std::size_t e = 0; e < sides.edges.size(); ++e) {
      const geometry::CellEdge& edge = complex.edge(sides.edges[e].front().edge);
      if (std::min(edge.start, edge.end) == VertexId(i) && std::max(edge.start, edge.end) == VertexId(i + 6))
        loop.loop.places.push_back(LoopPlace::inside(EdgeId(static_cast<int>(e))));
    }
    for (std::size_t f = 0; f < sides.faces.size(); ++f)
      if (sides.faces[f].front().face == FaceId(2 + i))
        loop.loop.steps.push_back(LoopStep::across(FaceId(static_cast<int>(f))));
    const auto& [x, y] = hexagon[static_cast<std::size_t>(i)];
    loop.points.emplace_back(x, y, i % 2 == 0 ? 0.4 : 0.6);
  }
  CutOptions options;
  options.keep_plane = false;
  EXPECT_NE(cut_cell(prism, complex, CellId(0), sides, loop, options).refusal.find("no surface is known"),
            std::string::npos);
  options.free_form = true;
  const CutAttempt attempt = cut_cell(prism, complex, CellId(0), sides, loop, options);
  ASSERT_TRUE(attempt.cut) << attempt.refusal;
  double volume = 0;
  for (const geometry::Brep& piece :
       cell_solids(prism, attempt.cut->complex, {attempt.cut->left, attempt.cut->right})) {
    EXPECT_GT(piece.volume(), 0.3 * prism.volume());
    volume += piece.volume();
  }
  EXPECT_NEAR(volume, prism.volume(), 1e-5 * prism.volume());
}

}  // namespace
}  // namespace isopatch::segmentation
