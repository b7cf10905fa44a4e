#include "segmentation/decomposition/combinatorics/loop_cost.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/base/tests/expect_error.hpp"
#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::segmentation {
namespace {

// Angles and lengths of a handful of points: rounding alone.
constexpr double rounding = 1e-12;
// Of the eigenvalue whose root a distance is.
constexpr double root_of_rounding = 1e-7;

Eigen::Matrix3Xd cube_points() {
  Eigen::Matrix3Xd points(3, 8);
  points << 0, 1, 1, 0, 0, 1, 1, 0,  //
      0, 0, 1, 1, 0, 0, 1, 1,        //
      0, 0, 0, 0, 1, 1, 1, 1;
  return points;
}

LoopCost cost_of(const CellGraph& graph, const CellGeometry& geometry, const std::vector<LoopPlace>& places,
                 const CostOptions& options = {}, Extension first_step = Extension::none) {
  const CellIncidence incidence(graph);
  CuttingLoop loop = loop_through(graph, incidence, places);
  loop.steps[0].extension = first_step;
  HexahedraCount count;
  return loop_cost(graph, incidence, geometry, loop, cut_along(graph, loop), count, options);
}

LoopPlace corner(int v) {
  return LoopPlace::at(VertexId(v));
}
LoopPlace middle(const CellGraph& graph, int a, int b) {
  return LoopPlace::inside(*edge_between(graph, VertexId(a), VertexId(b)));
}

TEST(LoopCost, CountsWhatTheGraphTells) {
  const LoopCost cost = cost_of(test::cube(), {}, {corner(0), corner(4), corner(6), corner(2)});
  EXPECT_EQ(cost.length, 0);
  EXPECT_EQ(cost.auxiliary_edges, 2);
  EXPECT_EQ(cost.auxiliary_vertices, 0);
  EXPECT_EQ(cost.face_size, 4);  // two squares into four triangles
  EXPECT_EQ(cost.hexahedra, 6);  // two prisms
  EXPECT_EQ(cost.planarity + cost.direction + cost.dihedral + cost.t_joints, 0);
}

TEST(LoopCost, PrefersHexagonsInTwoQuadrilaterals) {
  const CellGraph graph = test::prism(6);
  const LoopCost even = cost_of(graph, {}, {corner(0), corner(6), corner(9), corner(3)});
  const LoopCost odd = cost_of(graph, {}, {corner(0), corner(6), corner(8), corner(2)});
  EXPECT_EQ(even.face_size, 0);
  EXPECT_EQ(odd.face_size, 0);  // 3 and 5 instead of 6, twice: as far from four as before
  EXPECT_LT(even.total, odd.total);
}

TEST(LoopCost, MeasuresPlanesAndAngles) {
  const CellGraph cube = test::cube();
  const CellGeometry geometry{cube_points(), {}};
  const std::vector<LoopPlace> diagonal = {corner(0), corner(4), corner(6), corner(2)};
  CostOptions options;
  const LoopCost flat = cost_of(cube, geometry, diagonal, options);
  EXPECT_NEAR(flat.planarity, 0, root_of_rounding);
  EXPECT_NEAR(flat.direction, 0, rounding);
  EXPECT_NEAR(flat.dihedral, 0, rounding);
  options.dihedral_limit = Angle::degrees(60);
  EXPECT_NEAR(cost_of(cube, geometry, diagonal, options).dihedral, 0.25,
              rounding);  // 45 degrees at both edges
  CellGeometry bent = geometry;
  bent.points(2, 6) = 1.5;
  const LoopCost uneven = cost_of(cube, bent, diagonal);
  EXPECT_NEAR(uneven.planarity, 0, root_of_rounding);  // moved within the diagonal plane
  bent.points(0, 6) = 1.5;
  EXPECT_GT(cost_of(cube, bent, diagonal).planarity, 0.01);
  // A chord that divides a right angle 3 : 1 at one end and 1 : 3 at the other, on both faces.
  bent = geometry;
  const double slope = std::tan(std::numbers::pi / 8);
  for (const int v : {2, 6}) bent.points(1, v) = slope;
  const LoopCost skew = cost_of(cube, bent, diagonal);
  EXPECT_GT(skew.direction, 1);
}

TEST(LoopCost, DoesNotDependOnSizeAndPlace) {
  const CellGraph cube = test::cube();
  CellGeometry geometry{cube_points(), {}};
  geometry.points(0, 6) = 1.3;
  const std::vector<LoopPlace> diagonal = {corner(0), corner(4), corner(6), corner(2)};
  const double before = cost_of(cube, geometry, diagonal).total;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  geometry.points = (1000 * turn * geometry.points).colwise() + Eigen::Vector3d(5, 6, 7);
  EXPECT_NEAR(cost_of(cube, geometry, diagonal).total, before, 1e-9);
}

TEST(LoopCost, SeesWhetherAnEdgeStaysNonConvex) {
  const CellGraph graph = test::l_shape();
  const CellGeometry geometry{test::l_shape_points(), {}};
  const LoopCost bisecting = cost_of(graph, geometry, {corner(3), corner(9), corner(6), corner(0)});
  EXPECT_EQ(bisecting.non_convex, 0);
  const LoopCost slanted = cost_of(graph, geometry, {corner(3), corner(9), corner(7), corner(1)});
  EXPECT_EQ(slanted.non_convex, 1);  // 45 and 225 degrees
  const LoopCost extending =
      cost_of(graph, geometry, {corner(3), corner(9), middle(graph, 11, 6), middle(graph, 5, 0)}, {},
              Extension::left);
  EXPECT_EQ(extending.non_convex, 0);
  EXPECT_EQ(extending.hexahedra, 2);
  EXPECT_EQ(extending.auxiliary_vertices, 2);
}

TEST(LoopCost, SeesACutThatLeavesTheCell) {
  // From one end of the L to the other, across the corner that is not there.
  const CellGraph graph = test::l_shape();
  const CellGeometry geometry{test::l_shape_points(), {}};
  EXPECT_EQ(cost_of(graph, geometry, {corner(2), corner(8), corner(10), corner(4)}).dihedral, 1);
}

TEST(LoopCost, CountsTJointsOnFacesWithNeighbours) {
  const CellGraph graph = test::l_shape();
  CellGeometry geometry;
  geometry.has_neighbour.assign(8, false);
  const std::vector<LoopPlace> places = {corner(3), corner(9), middle(graph, 11, 6), middle(graph, 5, 0)};
  EXPECT_EQ(cost_of(graph, geometry, places).t_joints, 0);
  geometry.has_neighbour[7] = true;  // the top: an edge across it and a vertex on its border
  EXPECT_EQ(cost_of(graph, geometry, places).t_joints, 2);
}

TEST(LoopCost, RefusesPointsThatAreNotOneAVertex) {
  CellGeometry geometry{cube_points().leftCols(7), {}};
  const std::vector<LoopPlace> diagonal = {corner(0), corner(4), corner(6), corner(2)};
  EXPECT_ERROR(cost_of(test::cube(), geometry, diagonal), ErrorCode::invalid_argument, "7 points");
  geometry = {{}, {true}};
  EXPECT_ERROR(cost_of(test::cube(), geometry, diagonal), ErrorCode::invalid_argument, "1 marks");
}

TEST(CostOptions, NamesWhatIsOutOfRange) {
  CostOptions options;
  options.t_joint = -1;
  EXPECT_ERROR(validate(options), ErrorCode::invalid_argument, "t_joint");
  options = {};
  options.planarity = std::numeric_limits<double>::quiet_NaN();
  EXPECT_ERROR(validate(options), ErrorCode::invalid_argument, "planarity");
  options = {};
  options.exact_up_to = 17;
  EXPECT_ERROR(validate(options), ErrorCode::invalid_argument, "exact_up_to");
  options = {};
  options.dihedral_limit = Angle::degrees(181);
  EXPECT_ERROR(validate(options), ErrorCode::invalid_argument, "dihedral_limit");
}

}  // namespace
}  // namespace isopatch::segmentation
