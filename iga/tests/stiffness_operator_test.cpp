#include "iga/operator/stiffness_operator.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "solvers/block_product.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/LU>
#include <numeric>
#include <random>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/sphere.hpp"
#include "geometry/quadrature.hpp"
#include "iga/assembly/assembly.hpp"
#include "iga/operator/internal/patch_operator.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;
using geometry::NurbsVolume;

// Round-off: sums of some hundred products, all of about the size of the largest entry.
constexpr double same = 1e-13;

int node_count(const std::vector<PatchSpace>& spaces) {
  int count = 0;
  for (const PatchSpace& space : spaces) count += space.size();
  return count;
}

Eigen::Matrix3Xd random_field(int nodes, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::Matrix3Xd::NullaryExpr(3, nodes, [&] { return uniform(random); });
}

std::vector<Material> different_materials(std::size_t count) {
  std::vector<Material> materials;
  for (std::size_t p = 0; p < count; ++p)
    materials.push_back(isotropic(1 + static_cast<double>(p), 0.45 - 0.1 * static_cast<double>(p % 3)));
  return materials;
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / b.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

// Products of several displacements at once, more than one pass takes, against each alone.
void expect_several_as_one(const StiffnessOperator& stiffness) {
  std::vector<Eigen::Matrix3Xd> u;
  for (unsigned i = 0; i < 7; ++i) u.push_back(random_field(stiffness.node_count(), 20 + i));
  for (const std::size_t count : {1, 2, 7}) {
    const std::vector<Eigen::Matrix3Xd> forces = stiffness.apply(std::vector(u.begin(), u.begin() + count));
    ASSERT_EQ(forces.size(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_LT(difference(forces[i], stiffness.apply(u[i])), same);
  }
}

// The operator against the matrix: a product, and the diagonal blocks.
void expect_the_assembled_matrix(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                                 int points = 0) {
  const std::vector<Material> materials = different_materials(spaces.size());
  const int nodes = node_count(spaces);
  RowNumbering numbering{std::vector<int>(static_cast<std::size_t>(nodes)), nodes};
  std::iota(numbering.row_of_node.begin(), numbering.row_of_node.end(), 0);
  const auto matrix = assemble_stiffness(spaces, parts, materials, numbering, points);
  const StiffnessOperator stiffness(spaces, parts, materials, points);

  const Eigen::Matrix3Xd u = random_field(nodes);
  const Eigen::VectorXd expected =
      solvers::multiply(matrix, Eigen::Map<const Eigen::VectorXd>(u.data(), u.size()));
  EXPECT_LT(difference(stiffness.apply(u), Eigen::Map<const Eigen::Matrix3Xd>(expected.data(), 3, nodes)),
            same);
  expect_several_as_one(stiffness);

  const std::vector<Eigen::Matrix3d> blocks = stiffness.diagonal_blocks();
  ASSERT_EQ(blocks.size(), static_cast<std::size_t>(nodes));
  double worst = 0, largest = 0;
  for (std::size_t a = 0; a < blocks.size(); ++a) {
    const Eigen::Map<const Eigen::Matrix3d> block(
        &matrix.values[static_cast<std::size_t>(9 * matrix.row_start[a])]);
    worst = isopatch::larger(worst, (blocks[a] - block).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
    largest = isopatch::larger(largest, block.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
  EXPECT_LT(worst, same * largest);
}

void expect_the_assembled_matrix(const geometry::PatchSet& patches, const DiscretizationOptions& options,
                                 int points = 0) {
  const Discretization d = discretize(geometry::connect(patches), options);
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  expect_the_assembled_matrix(spaces, whole_patches(spaces), points);
}

// A prism over a triangle, one of whose vertices is a whole edge of the parameter domain.
geometry::PatchSet wedge() {
  Eigen::Matrix3Xd points(3, 8);
  for (int k = 0; k < 2; ++k) {
    points.col(4 * k) = points.col(4 * k + 2) = Eigen::Vector3d(0, 0, k);
    points.col(4 * k + 1) = Eigen::Vector3d(1, 0, k);
    points.col(4 * k + 3) = Eigen::Vector3d(0.2, 1.1, k);
  }
  return {{NurbsVolume({}, points)}, {}, {}};
}

TEST(StiffnessOperator, EqualsTheMatrixOnACurvedPatchOfEveryDegree) {
  for (const int p : {2, 3, 4, 5}) {
    SCOPED_TRACE(p);
    expect_the_assembled_matrix(geometry::box_model({.curvature = 0.3}),
                                {.degree = {p, p, p}, .elements_per_direction = {3, 2, 4}});
  }
}

TEST(StiffnessOperator, EqualsTheMatrixOnRationalPatches) {
  expect_the_assembled_matrix(geometry::cylinder_model({}),
                              {.degree = {3, 3, 3}, .elements_per_direction = {3, 4, 2}});
  expect_the_assembled_matrix(geometry::sphere_model({}), {});
}

TEST(StiffnessOperator, EqualsTheMatrixForMixedAndHighDegrees) {
  expect_the_assembled_matrix(geometry::cylinder_model({}),
                              {.degree = {1, 4, 2}, .elements_per_direction = {5, 2, 3}});
  expect_the_assembled_matrix(geometry::box_model({.distortion = 0.3}), {.degree = {7, 1, 2}});
}

TEST(StiffnessOperator, EqualsTheMatrixWhereKnotsAreRepeated) {
  expect_the_assembled_matrix(geometry::cylinder_model({}),
                              {.degree = {2, 3, 3}, .elements_per_direction = {3, 2, 3}, .continuity = 0});
}

TEST(StiffnessOperator, EqualsTheMatrixOnManyPatchesOfAnyOrientation) {
  expect_the_assembled_matrix(
      geometry::box_model({.patches = {2, 2, 2}, .distortion = 0.2, .curvature = 0.2, .orientation_seed = 3}),
      {.elements_per_direction = {2, 3, 1}});
}

TEST(StiffnessOperator, EqualsTheMatrixOnACollapsedEdge) {
  expect_the_assembled_matrix(wedge(), {.degree = {2, 2, 2}, .elements_per_direction = {3, 3, 2}});
}

TEST(StiffnessOperator, EqualsTheMatrixWithAnotherNumberOfGaussPoints) {
  for (const int points : {2, 5}) {
    SCOPED_TRACE(points);
    expect_the_assembled_matrix(geometry::cylinder_model({}),
                                {.degree = {3, 3, 3}, .elements_per_direction = {2, 2, 2}}, points);
  }
}

TEST(StiffnessOperator, EqualsTheMatrixOnPatchesCutIntoBoxes) {
  expect_the_assembled_matrix(geometry::box_model({.curvature = 0.3}),
                              {.elements_per_direction = {3, 13, 14}});
  expect_the_assembled_matrix(geometry::box_model({.curvature = 0.3}),
                              {.elements_per_direction = {30, 2, 2}});
}

// The plain way, sharing nothing with the operator but the splines: strains of every function at every point.
Eigen::MatrixXd plain_stiffness(const PatchSpace& space, const Material& material) {
  const int n = space.size();
  Eigen::Matrix<double, 6, 6> elasticity = Eigen::Matrix<double, 6, 6>::Zero();
  elasticity.topLeftCorner<3, 3>().setConstant(material.lambda);
  elasticity.diagonal().array() += material.mu;
  elasticity.diagonal().head<3>().array() += material.mu;
  std::vector<NurbsVolume> functions;  // each function as the x coordinate of a map
  for (int a = 0; a < n; ++a) {
    Eigen::Matrix3Xd unit = Eigen::Matrix3Xd::Zero(3, n);
    unit(0, a) = 1;
    functions.emplace_back(space.knots, unit, space.is_rational() ? space.weights : Eigen::VectorXd::Ones(n));
  }
  std::array<std::vector<double>, 3> nodes, weights;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto rule = geometry::gauss_legendre(space.knots[d].degree() + 1);
    const auto breaks = space.knots[d].breaks();
    for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
      for (Eigen::Index q = 0; q < rule.nodes.size(); ++q) {
        nodes[d].push_back(breaks[e] + (breaks[e + 1] - breaks[e]) * rule.nodes[q]);
        weights[d].push_back((breaks[e + 1] - breaks[e]) * rule.weights[q]);
      }
  }
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (std::size_t k = 0; k < nodes[2].size(); ++k)
    for (std::size_t j = 0; j < nodes[1].size(); ++j)
      for (std::size_t i = 0; i < nodes[0].size(); ++i) {
        const geometry::Parameter<3> at(nodes[0][i], nodes[1][j], nodes[2][k]);
        const Eigen::Matrix3d jacobian = space.geometry->jacobian(at);
        Eigen::MatrixXd strains = Eigen::MatrixXd::Zero(6, 3 * n);
        for (int a = 0; a < n; ++a) {
          const Eigen::RowVector3d g =
              functions[static_cast<std::size_t>(a)].jacobian(at).row(0) * jacobian.inverse();
          strains.middleCols<3>(3 * a) << g[0], 0, 0, 0, g[1], 0, 0, 0, g[2], g[1], g[0], 0, 0, g[2], g[1],
              g[2], 0, g[0];
        }
        stiffness += weights[0][i] * weights[1][j] * weights[2][k] * jacobian.determinant() *
                     strains.transpose() * elasticity * strains;
      }
  return stiffness;
}

// Functions of degrees 1 and 2 on few elements over a finer geometry of higher degree, rational or not on
// either side.
TEST(StiffnessOperator, EqualsThePlainProductWhereFunctionsAreCoarserThanTheGeometry) {
  const Material material = isotropic(3, 0.3);
  for (const bool rational_geometry : {false, true})
    for (const bool rational_functions : {false, true}) {
      SCOPED_TRACE(rational_geometry);
      SCOPED_TRACE(rational_functions);
      const geometry::MultiPatch model = geometry::connect(
          rational_geometry ? geometry::cylinder_model({}) : geometry::box_model({.curvature = 0.3}));
      const Discretization d = discretize(model, {.degree = {3, 2, 3}, .elements_per_direction = {4, 4, 3}});
      PatchSpace space{
          &d.patches[0], {KnotVector::uniform(1, 2), KnotVector::uniform(2, 2), KnotVector::bezier(2)}, {}};
      ASSERT_EQ(d.patches[0].knots(0).length(), 1);
      if (rational_functions)
        space.weights = (random_field(space.size(), 5).row(0).transpose().array() * 0.3 + 1).matrix();
      const std::vector<PatchSpace> spaces = {space};
      const StiffnessOperator stiffness(spaces, whole_patches(spaces), {material});
      const Eigen::MatrixXd plain = plain_stiffness(space, material);
      const Eigen::Matrix3Xd u = random_field(space.size());
      const Eigen::VectorXd expected = plain * Eigen::Map<const Eigen::VectorXd>(u.data(), u.size());
      EXPECT_LT(difference(stiffness.apply(u),
                           Eigen::Map<const Eigen::Matrix3Xd>(expected.data(), 3, space.size())),
                same);
      expect_several_as_one(stiffness);
      const std::vector<Eigen::Matrix3d> blocks = stiffness.diagonal_blocks();
      for (int a = 0; a < space.size(); ++a)
        EXPECT_LT((blocks[static_cast<std::size_t>(a)] - plain.block<3, 3>(3 * a, 3 * a))
                      .cwiseAbs()
                      .maxCoeff<Eigen::PropagateNaN>(),
                  same * plain.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
    }
}

TEST(StiffnessOperator, IsSymmetric) {
  const Discretization d = discretize(geometry::connect(geometry::cylinder_model({})), {.refine = 2});
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  const StiffnessOperator stiffness(spaces, whole_patches(spaces), different_materials(1));
  const Eigen::Matrix3Xd x = random_field(d.node_count(), 1), y = random_field(d.node_count(), 2);
  const Eigen::Matrix3Xd kx = stiffness.apply(x), ky = stiffness.apply(y);
  EXPECT_NEAR(kx.cwiseProduct(y).sum(), ky.cwiseProduct(x).sum(), same * kx.norm() * y.norm());
}

TEST(StiffnessOperator, MakesNoForceOfARigidMotion) {
  const Discretization d =
      discretize(geometry::connect(geometry::cylinder_model({})), {.degree = {3, 3, 3}, .refine = 1});
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  const StiffnessOperator stiffness(spaces, whole_patches(spaces), different_materials(1));
  const Eigen::Matrix3Xd& points = d.patches[0].control_points();
  const double usual =
      stiffness.apply(random_field(d.node_count())).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Matrix3Xd shift = Eigen::Matrix3Xd::Zero(3, points.cols()), turn = shift;
    shift.row(axis).setOnes();
    turn.row((axis + 1) % 3) = -points.row((axis + 2) % 3);
    turn.row((axis + 2) % 3) = points.row((axis + 1) % 3);
    EXPECT_LT(stiffness.apply(shift).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), same * usual);
    EXPECT_LT(stiffness.apply(turn).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), same * usual);
  }
}

TEST(StiffnessOperator, SumsOverPartsToTheWhole) {
  const Discretization d =
      discretize(geometry::connect(geometry::box_model({.patches = {2, 1, 1}, .curvature = 0.3})),
                 {.elements_per_direction = {2, 3, 15}});
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  const std::vector<Material> materials = different_materials(2);
  const Eigen::Matrix3Xd u = random_field(d.node_count());
  const int layers = spaces[0].knots[2].element_count();
  const std::vector<PatchLayers> low = {{0, 0, 7}, {0, 7, 8}}, high = {{0, 8, layers}};
  const Eigen::Matrix3Xd whole = StiffnessOperator(spaces, whole_patches(spaces), materials).apply(u);
  const Eigen::Matrix3Xd first = StiffnessOperator(spaces, low, materials).apply(u);
  const Eigen::Matrix3Xd second = StiffnessOperator(spaces, high, materials).apply(u);
  const int nodes = spaces[0].size();
  EXPECT_LT(difference((first + second).leftCols(nodes), whole.leftCols(nodes)), same);
  EXPECT_EQ(first.rightCols(d.node_count() - nodes).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 0);
  EXPECT_GT(first.leftCols(nodes).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 0);
  // All elements of layers 0 .. 7 end below the functions of the last layers.
  EXPECT_EQ(first.middleCols(nodes - 5, 5).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 0);
}

// Small patches too have work for several threads, in boxes of about one size.
TEST(PatchOperator, CutsEveryPatchIntoEqualBoxes) {
  for (const auto& [degree, elements] : {std::array{2, 16}, std::array{3, 16}, std::array{4, 12}}) {
    SCOPED_TRACE(degree);
    const Discretization d = discretize(
        geometry::connect(geometry::box_model({})),
        {.degree = {degree, degree, degree}, .elements_per_direction = {elements, elements, elements}});
    const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
    const PatchOperator patch(0, spaces[0], different_materials(1)[0], 0);
    const std::vector<ElementBox> boxes = patch.boxes(0, elements);
    int whole = 0, largest = 0;
    for (const ElementBox& box : boxes) {
      int size = 1;
      for (std::size_t k = 0; k < 3; ++k) size *= box.end[k] - box.begin[k];
      whole += size;
      largest = isopatch::larger(largest, size);
    }
    const int bands = (elements * (degree + 1) + lane_count - 1) / lane_count;
    EXPECT_EQ(whole, bands * elements * elements);
    EXPECT_GE(whole, 8 * largest);
  }
}

TEST(StiffnessOperator, GivesTheSameBitsForAnyNumberOfThreads) {
  const Discretization d =
      discretize(geometry::connect(geometry::box_model({.patches = {2, 1, 1}, .curvature = 0.3})),
                 {.elements_per_direction = {4, 13, 18}});
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  const StiffnessOperator stiffness(spaces, whole_patches(spaces), different_materials(2));
  const Eigen::Matrix3Xd u = random_field(d.node_count());
  const int usual = omp_get_max_threads();
  omp_set_num_threads(1);
  const Eigen::Matrix3Xd one = stiffness.apply(u);
  const std::vector<Eigen::Matrix3Xd> fields = {u, 2 * u, one};
  const std::vector<Eigen::Matrix3Xd> several = stiffness.apply(fields);
  const std::vector<Eigen::Matrix3d> blocks = stiffness.diagonal_blocks();
  for (const int threads : {2, 5}) {
    omp_set_num_threads(threads);
    for (int repeat = 0; repeat < 10; ++repeat) EXPECT_EQ(stiffness.apply(u), one) << threads;
    EXPECT_EQ(stiffness.apply(fields), several) << threads;
    EXPECT_EQ(stiffness.diagonal_blocks(), blocks) << threads;
  }
  omp_set_num_threads(usual);
}

TEST(StiffnessOperator, KeepsTablesOfLinesOnly) {
  const auto kept = [](int elements) {
    const Discretization d =
        discretize(geometry::connect(geometry::cylinder_model({})),
                   {.degree = {3, 3, 3}, .elements_per_direction = {elements, elements, elements}});
    const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
    return StiffnessOperator(spaces, whole_patches(spaces), different_materials(1)).bytes();
  };
  EXPECT_LT(kept(16), 2.2 * static_cast<double>(kept(8)));  // of eight times the elements
  EXPECT_GT(kept(8), 1000);
}

TEST(StiffnessOperator, NamesAFoldedPatch) {
  NurbsVolume volume;
  Eigen::Matrix3Xd points = volume.control_points();
  points.col(7) = Eigen::Vector3d(-0.5, -0.5, 0.5);  // the corner (1, 1, 1) pulled through the opposite side
  volume = NurbsVolume(volume.knots(), points);
  const std::vector<PatchSpace> spaces = {{&volume, volume.knots(), {}}};
  const StiffnessOperator stiffness(spaces, whole_patches(spaces), different_materials(1));
  try {
    stiffness.apply(random_field(8));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::fold_over);
    EXPECT_THAT(error.what(), ::testing::HasSubstr("patch 0 is folded"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("(0.788675, 0.788675, 0.788675)"));
  }
}

TEST(StiffnessOperator, RefusesCountsThatDoNotFit) {
  const NurbsVolume volume;
  const std::vector<PatchSpace> spaces = {{&volume, volume.knots(), {}}};
  const std::vector<Material> one = different_materials(1);
  EXPECT_ERROR(StiffnessOperator(spaces, whole_patches(spaces), {}), ErrorCode::invalid_argument,
               "0 materials for 1 patches");
  EXPECT_ERROR(StiffnessOperator(spaces, {{1, 0, 1}}, one), ErrorCode::invalid_argument,
               "belongs to patch 1 of 1");
  EXPECT_ERROR(StiffnessOperator(spaces, {{0, 0, 2}}, one), ErrorCode::invalid_argument,
               "layers 0 .. 2 of patch 0");
  EXPECT_ERROR(StiffnessOperator(spaces, whole_patches(spaces), one, 65), ErrorCode::invalid_argument,
               "65 Gauss points");
  EXPECT_ERROR(StiffnessOperator(spaces, whole_patches(spaces), one).apply(random_field(7)),
               ErrorCode::invalid_argument, "the displacement has 7 nodes");
}

}  // namespace
}  // namespace isopatch::iga
