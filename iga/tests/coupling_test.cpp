#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/reorient.hpp"
#include "geometry/models/sphere.hpp"
#include "geometry/splines/refine.hpp"
#include "iga/coupling/supported_system.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::MultiPatch;
using testing::boundary;
using testing::problem;

// Largest distance between control points of one global node, relative to the model.
double spread(const Discretization& d, const GlobalNodes& global) {
  std::vector<Eigen::Vector3d> places;
  for (const auto& patch : d.patches)
    for (int i = 0; i < patch.size(); ++i) places.push_back(patch.control_points().col(i));
  double result = 0;
  for (int c = 0; c < global.count(); ++c)
    for (const int node : global.nodes_of(c))
      result = isopatch::larger(result, (places[static_cast<std::size_t>(node)] -
                                         places[static_cast<std::size_t>(global.nodes_of(c)[0])])
                                            .norm());
  return result / d.model.size();
}

// Nodes of a box of patches counted without any coupling: a grid.
int grid_nodes(const std::array<int, 3>& patches, int functions) {
  int count = 1;
  for (const int n : patches) count *= n * (functions - 1) + 1;
  return count;
}

TEST(GlobalNodes, MakeOneGridOfPatchesInRandomOrientations) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    const MultiPatch model = geometry::connect(geometry::box_model(
        {.patches = {2, 3, 2}, .distortion = 0.3, .curvature = 0.2, .orientation_seed = seed}));
    const Discretization d = discretize(model, {.refine = 1});
    const GlobalNodes global = global_nodes(d);
    EXPECT_EQ(global.count(), grid_nodes({2, 3, 2}, 4));
    EXPECT_LT(spread(d, global), 1e-13);
  }
}

TEST(GlobalNodes, ClosesARing) {
  const MultiPatch model = geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(360)}));
  const Discretization d = discretize(model);
  EXPECT_EQ(model.interfaces().size(), 4u);
  EXPECT_EQ(global_nodes(d).count(), 2 * 2 * 8);
}

TEST(GlobalNodes, MergeTheControlPointsOfACollapsedFace) {
  // A wedge: the west side of a cube is pulled together to its edge along z.
  geometry::NurbsVolume cube;
  Eigen::Matrix3Xd points = cube.control_points();
  for (int i = 0; i < 8; ++i)
    if (points(0, i) == 0) points(1, i) = 0.5;
  const MultiPatch model = geometry::connect({{geometry::NurbsVolume(cube.knots(), points)}, {}, {}});
  ASSERT_EQ(model.degenerate_faces().size(), 1u);
  const Discretization d = discretize(model, {.degree = {2, 2, 2}});
  EXPECT_EQ(global_nodes(d).count(), 27 - 2 * 3);
  EXPECT_LT(spread(d, global_nodes(d)), 1e-15);
}

TEST(Discretization, MatchesDegreesAndKnotsOfNeighboursAcrossOrientations) {
  geometry::PatchSet set = geometry::box_model({.patches = {3, 1, 1}});
  geometry::NurbsVolume& first = set.patches[0];
  const auto finer = geometry::KnotVector(3, {0, 0, 0, 0, 0.2, 0.2, 0.7, 1, 1, 1, 1});
  first = geometry::NurbsVolume(first);
  set.patches[0] = geometry::refined(first, {first.knots(0), finer, first.knots(2)});
  const MultiPatch model = geometry::connect(geometry::randomly_reoriented(set, 11));
  const Discretization d = discretize(model);
  // All three patches get the first one's space across y: 7 functions; the others stay linear.
  EXPECT_EQ(d.node_count(), 3 * 7 * 2 * 2);
  EXPECT_EQ(global_nodes(d).count(), 4 * 7 * 2);
  EXPECT_LT(spread(d, global_nodes(d)), 1e-14);
}

TEST(Discretization, RefinesAsAsked) {
  const MultiPatch model = geometry::connect(geometry::box_model({.size = {4, 1, 1}}));
  EXPECT_EQ(discretize(model, {.refine = 2}).element_count(), 64);
  EXPECT_EQ(discretize(model, {.elements_per_direction = {3, 0, 2}}).element_count(), 6);
  EXPECT_EQ(discretize(model, {.max_size = 0.5}).element_count(), 8 * 2 * 2);
  const Discretization rough = discretize(model, {.degree = {3, 3, 3}, .refine = 1, .continuity = 0});
  EXPECT_EQ(rough.patches[0].size(0), 7);
  EXPECT_ERROR(discretize(model, {.degree = {11, 0, 0}}), ErrorCode::invalid_argument,
               "is 11; its range is 0 .. 10");
}

TEST(MultiplierRows, AreIndependentAndTieExactlyWhatEliminationMerges) {
  ElasticityProblem p = problem(geometry::connect(geometry::sphere_model({})), {}, isotropic(1, 0.3));
  const auto& model = p.discretization.model;
  p.supports = {
      {"x0", boundary(model, "x0"), PlaneSupport{}},
      {"inner", boundary(model, "inner"), PrescribedDisplacement{{std::nullopt, 0.0, std::nullopt}}}};
  const GlobalNodes global = global_nodes(p.discretization);
  const std::vector<SupportFrame> frames = support_frames(p, global);
  const auto rows = multiplier_rows(global, frames);
  const Eigen::MatrixXd b = multiplier_matrix(rows, p.discretization.node_count());
  const Eigen::VectorXd squares = symmetric_eigenvalues(b * b.transpose());
  EXPECT_GT(squares[0], 1e-10 * squares.maxCoeff<Eigen::PropagateNaN>());
  std::int64_t free_rows = 0;
  for (int c = 0; c < global.count(); ++c)
    free_rows +=
        (static_cast<std::int64_t>(global.nodes_of(c).size()) - 1) * frames[static_cast<std::size_t>(c)].free;
  EXPECT_EQ(b.rows(), free_rows);
}

TEST(MultiplierRows, DependentRowsAreRefused) {
  std::vector<MultiplierRow> rows = {{0, 0, 1, 0}, {0, 1, 2, 0}, {0, 0, 2, 0}};
  EXPECT_ERROR(multiplier_matrix(rows, 3), ErrorCode::internal, "linearly dependent");
  rows.pop_back();
  EXPECT_EQ(multiplier_matrix(rows, 3).rows(), 2);
}

TEST(SupportFrames, KeepOneDirectionWhereTwoObliquePlanesMeet) {
  const MultiPatch model = geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(50)}));
  ElasticityProblem p = problem(model, {}, isotropic(1, 0.3));
  p.supports = {{"start", boundary(model, "start"), PlaneSupport{}},
                {"end", boundary(model, "end"), PlaneSupport{1e-3}},
                {"bottom", boundary(model, "bottom"), PlaneSupport{}}};
  const GlobalNodes global = global_nodes(p.discretization);
  const Eigen::Vector3d normal(-std::sin(50 * M_PI / 180), std::cos(50 * M_PI / 180), 0);
  std::map<int, int> counts;
  for (const SupportFrame& frame : support_frames(p, global)) {
    ++counts[frame.free];
    EXPECT_LT((frame.axes.transpose() * frame.axes - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR((frame.axes.leftCols(frame.free).transpose() * frame.prescribed).norm(), 0, 1e-18);
    if (frame.free == 2 && frame.support[2] == 1) {
      EXPECT_LT((frame.prescribed - 1e-3 * normal).norm(), 1e-15);
    }
  }
  // One patch of 2 x 3 x 2 points: 2 of the 12 are in no plane, 4 on one side plane above, 2 at the bottom
  // only.
  EXPECT_EQ(counts[3], 2);
  EXPECT_EQ(counts[2], 4 + 2);
  EXPECT_EQ(counts[1], 4);
}

TEST(SupportFrames, RefuseARollerOnACurvedFace) {
  const MultiPatch model = geometry::connect(geometry::cylinder_model({}));
  ElasticityProblem p = problem(model, {}, isotropic(1, 0.3));
  p.supports = {{"bore", boundary(model, "inner"), PlaneSupport{}}};
  try {
    support_frames(p, global_nodes(p.discretization));
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("is not plane"));
  }
}

}  // namespace
}  // namespace isopatch::iga
