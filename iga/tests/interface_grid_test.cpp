// Interfaces by sum factorization, where both sides have the same lines of equal parameters, against the sums
// over cells that any sides take.

#include <gtest/gtest.h>

#include "geometry/base/larger.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "iga/assembly/internal/cell_interface.hpp"
#include "iga/assembly/internal/grid_interface.hpp"
#include "iga/assembly/internal/grid_traces.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::MultiPatch;
using geometry::Side;

const Material first_material = isotropic(2, 0.3), second_material = isotropic(3, 0.2);

// Spaces of a model whose patches have 2, 3, 2, 3, ... elements along every direction.
Discretization apart(const MultiPatch& model, int degree) {
  DiscretizationOptions options{.degree = {degree, degree, degree}, .spread = false};
  for (int p = 0; p < model.patch_count(); ++p)
    options.patches.push_back({.patches = {p}, .elements_per_direction = {2 + p % 2, 2 + p % 2, 2 + p % 2}});
  return discretize(model, options);
}

Eigen::Matrix3Xd forces(const NodeBlocks& blocks, int nodes) {
  std::srand(7);
  const Eigen::Matrix3Xd displacement = Eigen::Matrix3Xd::Random(3, nodes);
  Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, nodes);
  blocks.add_forces(displacement, result);
  return result;
}

// The two ways on an interface, with the same number of points in each cell.
struct BothWays {
  const Discretization& discretization;
  std::vector<PatchSpace> spaces;
  std::vector<int> first_node;
  double same_point;

  explicit BothWays(const Discretization& d)
      : discretization(d),
        spaces(isoparametric_spaces(d)),
        first_node(first_nodes(spaces)),
        same_point(d.model.tolerance().same_point * d.model.size()) {}

  template <class SideOf>
  SideOf side(const geometry::PatchFace& face) const {
    const auto p = static_cast<std::size_t>(face.patch.value);
    return {spaces[p], face.side, first_node[p]};
  }

  // The largest difference of nodes' forces, as a share of the largest force.
  double difference(const geometry::PatchFace& first, const geometry::PatchFace& second, int points) const {
    const auto own = side<PatchSide>(first), other = side<PatchSide>(second);
    const auto of_own = side<SideFunctions>(first), of_other = side<SideFunctions>(second);
    const Eigen::MatrixXd penalties = 3 * trace_constants(of_own);
    const auto grid = geometry::shared_grid(own.divided(), other.divided(), {points, points}, same_point);
    if (!grid) return std::numeric_limits<double>::infinity();
    const int nodes = first_node.back();
    const Eigen::Matrix3Xd fast =
        forces(grid_stiffness(of_own, of_other, *grid, penalties, first_material), nodes);
    const Eigen::Matrix3Xd plain =
        forces(cell_stiffness(own, other, penalties, first_material, points, same_point), nodes);
    return (fast - plain).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() /
           plain.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  }
};

// All interfaces of a model, either side's tractions.
double largest_difference(const Discretization& d, int points) {
  const BothWays ways(d);
  double result = 0;
  EXPECT_FALSE(d.model.non_matching().empty());
  for (const geometry::NonMatchingInterface& interface : d.model.non_matching()) {
    result = isopatch::larger(result, ways.difference(interface.first, interface.second, points));
    result = isopatch::larger(result, ways.difference(interface.second, interface.first, points));
  }
  return result;
}

TEST(InterfaceGrid, IsTheSumOverCellsOnPlanesInAllOrientations) {
  for (const unsigned seed : {1u, 2u, 3u})
    for (const int degree : {1, 2, 3}) {
      const MultiPatch model =
          geometry::connect(geometry::box_model({.patches = {2, 2, 2}, .orientation_seed = seed}));
      EXPECT_LT(largest_difference(apart(model, degree), degree + 2), 1e-12) << seed << " " << degree;
    }
}

// Edges of elements are no straight lines in space, but still the same lines of parameters. The rules differ
// where the normal turns.
TEST(InterfaceGrid, IsTheSumOverCellsOnCurvedFaces) {
  const MultiPatch model = geometry::connect(geometry::box_model(
      {.patches = {2, 1, 2}, .distortion = 0.2, .curvature = 0.3, .orientation_seed = 5}));
  EXPECT_LT(largest_difference(apart(model, 2), 10), 1e-9);
}

// Two layers of a tube's wall; angles in degrees.
MultiPatch rings(double inside, double outside) {
  geometry::PatchSet set = geometry::cylinder_model({.angle = Angle::degrees(inside)});
  set.boundaries.clear();
  set.patches.push_back(
      geometry::cylinder_model({.inner_radius = 2, .outer_radius = 3, .angle = Angle::degrees(outside)})
          .patches.front());
  return geometry::connect(set, {.keep_non_matching = true});
}

// Two boxes.
MultiPatch boxes(const geometry::BoxOptions& first, const geometry::BoxOptions& second) {
  geometry::PatchSet set = geometry::box_model(first);
  set.boundaries.clear();
  set.patches.push_back(geometry::box_model(second).patches.front());
  return geometry::connect(set, {.keep_non_matching = true});
}

// Rational functions, and of one cylinder arcs of other parameters: one lies within the other.
TEST(InterfaceGrid, IsTheSumOverCellsOnArcsOfOtherParameters) {
  EXPECT_LT(largest_difference(apart(rings(60, 60), 2), 10), 1e-10);
  EXPECT_LT(largest_difference(apart(rings(80, 30), 3), 12), 1e-9);
}

// A small patch on a part of a large one.
TEST(InterfaceGrid, IsTheSumOverCellsAtTJoints) {
  const Discretization d =
      apart(boxes({.size = {3, 2, 1}}, {.size = {1.3, 2.2, 1}, .origin = {0.4, 0.3, 1}}), 2);
  EXPECT_LT(largest_difference(d, 4), 1e-12);
}

// As a patch that meets itself has.
TEST(InterfaceGrid, ServesNodesThatAreOnBothSides) {
  const Discretization d = apart(boxes({}, {.origin = {1, 0, 0}}), 2);
  BothWays ways(d);
  // All nodes of both patches numbered alike, so that nodes of the two sides coincide.
  ways.first_node[1] = 0;
  ways.first_node.back() = std::max(ways.spaces[0].size(), ways.spaces[1].size());
  EXPECT_LT(ways.difference({PatchId(0), Side::east}, {PatchId(1), Side::west}, 4), 1e-12);
}

// The place itself is a field that both sides have, and 1 is another.
TEST(InterfaceGrid, TracesOfBothSidesAgreeOnFieldsThatBothHave) {
  const MultiPatch turned = geometry::connect(geometry::box_model(
      {.patches = {2, 2, 1}, .distortion = 0.2, .curvature = 0.2, .orientation_seed = 3}));
  for (const MultiPatch& model : {turned, rings(80, 30)}) {
    const Discretization d = apart(model, 3);
    const BothWays ways(d);
    Eigen::Matrix4Xd fields(4, ways.first_node.back());
    for (int p = 0; p < d.patch_count(); ++p) {
      const geometry::NurbsVolume& patch = d.patches[static_cast<std::size_t>(p)];
      fields.middleCols(ways.first_node[static_cast<std::size_t>(p)], patch.size()) << patch.control_points(),
          Eigen::RowVectorXd::Ones(patch.size());
    }
    for (const geometry::NonMatchingInterface& interface : d.model.non_matching()) {
      const auto own = ways.side<PatchSide>(interface.first), other = ways.side<PatchSide>(interface.second);
      const auto of_own = ways.side<SideFunctions>(interface.first);
      const auto of_other = ways.side<SideFunctions>(interface.second);
      const auto grid = geometry::shared_grid(own.divided(), other.divided(), {6, 6}, ways.same_point);
      ASSERT_TRUE(grid);
      const TraceIntegrals traces = grid_traces(of_own, of_other, *grid);
      const int splines = own.knots(0).size() * own.knots(1).size();
      Eigen::MatrixX4d first = Eigen::MatrixX4d::Zero(splines, 4), second = first;
      for (const auto& entry : traces.of_own)
        first.row(entry.row()) += entry.value() * fields.col(entry.col());
      for (const auto& entry : traces.of_other)
        second.row(entry.row()) += entry.value() * fields.col(entry.col());
      EXPECT_LT((first - second).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 1e-12);
      const double area =
          geometry::shared_surface(*own.divided().surface, *other.divided().surface, ways.same_point).area;
      EXPECT_NEAR(first.col(3).sum(), area, 1e-8 * area);
    }
  }
}

}  // namespace
}  // namespace isopatch::iga
