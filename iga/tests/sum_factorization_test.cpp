#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <numeric>
#include <random>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "iga/assembly/assembly.hpp"
#include "iga/tests/plain_stiffness.hpp"
#include "iga/tests/small_models.hpp"
#include "solvers/block_product.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;
using geometry::NurbsVolume;
using Knots = std::array<KnotVector, 3>;

// Sums of some hundred products, taken in another order.
constexpr double round_off = 1e-13;

Knots uniform(const std::array<int, 3>& degrees, const std::array<int, 3>& elements) {
  return {KnotVector::uniform(degrees[0], elements[0]), KnotVector::uniform(degrees[1], elements[1]),
          KnotVector::uniform(degrees[2], elements[2])};
}

Eigen::VectorXd random_weights(Eigen::Index count, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform_number(0.7, 1.4);
  Eigen::VectorXd weights(count);
  for (double& weight : weights) weight = uniform_number(random);
  return weights;
}

// A cube with its control points moved by up to a fifth of their distance.
NurbsVolume bent_cube(const Knots& knots, bool rational, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  std::array<std::vector<double>, 3> places;
  for (std::size_t d = 0; d < 3; ++d) places[d] = knots[d].greville();
  Eigen::Matrix3Xd points(3, knots[0].size() * knots[1].size() * knots[2].size());
  for (int a = 0; a < points.cols(); ++a) {
    const std::array<int, 3> index = {a % knots[0].size(), a / knots[0].size() % knots[1].size(),
                                      a / knots[0].size() / knots[1].size()};
    for (std::size_t d = 0; d < 3; ++d)
      points(static_cast<int>(d), a) =
          places[d][static_cast<std::size_t>(index[d])] + move(random) / (knots[d].size() - 1);
  }
  if (!rational) return {knots, points};
  return {knots, points, random_weights(points.cols(), random)};
}

PatchSpace own_space(const NurbsVolume& volume) {
  return {&volume, volume.knots(), volume.is_rational() ? volume.weights() : Eigen::VectorXd(), false};
}

RowNumbering own_rows(const std::vector<PatchSpace>& spaces) {
  RowNumbering numbering;
  for (const PatchSpace& space : spaces) numbering.rows += space.size();
  numbering.row_of_node.resize(static_cast<std::size_t>(numbering.rows));
  std::iota(numbering.row_of_node.begin(), numbering.row_of_node.end(), 0);
  return numbering;
}

// Every row has some nodes, in no order at all.
RowNumbering random_rows(const std::vector<PatchSpace>& spaces, int rows, unsigned seed) {
  RowNumbering numbering = own_rows(spaces);
  for (int& row : numbering.row_of_node) row %= rows;
  std::shuffle(numbering.row_of_node.begin(), numbering.row_of_node.end(), std::mt19937(seed));
  numbering.rows = rows;
  return numbering;
}

std::vector<Material> materials_for(const std::vector<PatchSpace>& spaces) {
  std::vector<Material> materials;
  for (std::size_t p = 0; p < spaces.size(); ++p)
    materials.push_back(isotropic(1 + static_cast<double>(p), 0.3 - 0.2 * static_cast<double>(p)));
  return materials;
}

void expect_equals_plain(const std::vector<PatchSpace>& spaces, const RowNumbering& numbering,
                         int points = 0) {
  const std::vector<PatchLayers> parts = whole_patches(spaces);
  const std::vector<Material> materials = materials_for(spaces);
  const Eigen::MatrixXd fast = dense(assemble_stiffness(spaces, parts, materials, numbering, points));
  const Eigen::MatrixXd slow = plain_stiffness(spaces, parts, materials, numbering, points);
  EXPECT_LT((fast - slow).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
            round_off * slow.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

TEST(SumFactorization, EqualsThePlainAssemblerForAllMixturesOfDegrees) {
  unsigned seed = 0;
  for (const std::array<int, 3>& degrees : {std::array{1, 1, 1},
                                            {2, 2, 2},
                                            {3, 3, 3},
                                            {1, 2, 3},
                                            {3, 1, 2},
                                            {2, 3, 1},
                                            {4, 2, 1},
                                            {1, 4, 2},
                                            {2, 1, 5},
                                            {6, 1, 1},
                                            {1, 1, 8}}) {
    for (const bool rational : {false, true}) {
      const NurbsVolume volume = bent_cube(uniform(degrees, {3, 2, 2}), rational, ++seed);
      SCOPED_TRACE(::testing::Message()
                   << degrees[0] << degrees[1] << degrees[2] << (rational ? " rational" : ""));
      const std::vector<PatchSpace> spaces = {own_space(volume)};
      expect_equals_plain(spaces, own_rows(spaces));
    }
  }
}

TEST(SumFactorization, WorksOnSingleElementsLongLinesAndGroupsOfHighDegree) {
  // Long and flat, so that several tasks share a line; of high degree, so that direction 3 is worked on in
  // groups.
  for (const auto& [degrees, elements] : {std::pair{std::array{2, 3, 2}, std::array{1, 1, 1}},
                                          {{1, 1, 1}, {1, 1, 1}},
                                          {{1, 1, 1}, {40, 2, 1}},
                                          {{2, 1, 1}, {25, 1, 2}},
                                          {{1, 2, 1}, {1, 1, 20}},
                                          {{2, 10, 5}, {1, 1, 1}},
                                          {{3, 4, 4}, {5, 1, 1}}}) {
    const NurbsVolume volume = bent_cube(uniform(degrees, elements), true, 7);
    SCOPED_TRACE(::testing::Message() << degrees[0] << degrees[1] << degrees[2]);
    const std::vector<PatchSpace> spaces = {own_space(volume)};
    expect_equals_plain(spaces, own_rows(spaces));
  }
}

TEST(SumFactorization, KnowsRepeatedAndUnevenKnots) {
  const Knots knots = {KnotVector(3, {0, 0, 0, 0, 0.1, 0.4, 0.4, 0.4, 0.9, 1, 1, 1, 1}),
                       KnotVector(2, {-1, -1, -1, 2, 2, 3, 3, 3}),
                       KnotVector(2, {0, 0, 0, 0.5, 0.5, 0.75, 1, 1, 1})};
  for (const bool rational : {false, true}) {
    const NurbsVolume volume = bent_cube(knots, rational, 3);
    const std::vector<PatchSpace> spaces = {own_space(volume)};
    expect_equals_plain(spaces, own_rows(spaces));
    expect_equals_plain(spaces, own_rows(spaces), 2);
    expect_equals_plain(spaces, own_rows(spaces), 6);
  }
}

TEST(SumFactorization, TakesFunctionsCoarserThanTheGeometryOrOfAnotherDegree) {
  // The geometry has kinks, at 0.5 in direction 1 and 3, inside the functions' elements and, with three
  // points, just where a Gauss point lies.
  const Knots fine = {KnotVector(2, {0, 0, 0, 0.5, 0.5, 1, 1, 1}), KnotVector::uniform(3, 4),
                      KnotVector(1, {0, 0, 0.25, 0.5, 0.75, 1, 1})};
  std::mt19937 random(5);
  for (const bool rational_geometry : {false, true}) {
    const NurbsVolume volume = bent_cube(fine, rational_geometry, 11);
    for (const bool rational_functions : {false, true}) {
      for (const Knots& knots :
           {uniform({2, 2, 2}, {1, 2, 1}), uniform({1, 1, 1}, {2, 2, 2}), uniform({3, 1, 2}, {4, 3, 2})}) {
        PatchSpace space{&volume, knots, {}, false};
        if (rational_functions) space.weights = random_weights(space.size(), random);
        expect_equals_plain({space}, own_rows({space}));
      }
    }
  }
}

TEST(SumFactorization, SharesRowsInAnyOrder) {
  const NurbsVolume first = bent_cube(uniform({2, 1, 3}, {2, 3, 2}), true, 1);
  const NurbsVolume second = bent_cube(uniform({1, 2, 2}, {3, 1, 3}), false, 2);
  const std::vector<PatchSpace> spaces = {own_space(first), own_space(second)};
  const int nodes = spaces[0].size() + spaces[1].size();
  for (const int rows : {nodes, nodes - 10, nodes / 2, nodes / 5, 3, 2})
    expect_equals_plain(spaces, random_rows(spaces, rows, static_cast<unsigned>(rows)));
  RowNumbering backwards = own_rows(spaces);
  std::reverse(backwards.row_of_node.begin(), backwards.row_of_node.end());
  expect_equals_plain(spaces, backwards);
}

TEST(SumFactorization, JoinsTheNodesOfCollapsedEdges) {
  const NurbsVolume volume = bent_cube(uniform({2, 2, 2}, {2, 2, 2}), true, 4);
  const std::vector<PatchSpace> spaces = {own_space(volume)};
  for (int direction = 0; direction < 3; ++direction) {
    RowNumbering numbering = own_rows(spaces);
    const std::array<int, 3> step = {1, 4, 16};
    const auto k = static_cast<std::size_t>(direction);
    for (int i = 0; i < 4; ++i)  // a face becomes an edge
      for (int j = 1; j < 4; ++j)
        numbering.row_of_node[static_cast<std::size_t>(i * step[(k + 1) % 3] + j * step[k])] =
            i * step[(k + 1) % 3];
    expect_equals_plain(spaces, numbering);
    EXPECT_EQ(stiffness_size(spaces, whole_patches(spaces), numbering).blocks,
              stiffness_pattern(spaces, whole_patches(spaces), numbering).blocks());
  }
}

TEST(SumFactorization, PartsAddUpToTheWhole) {
  const NurbsVolume volume = bent_cube(uniform({2, 1, 2}, {2, 2, 5}), true, 9);
  const std::vector<PatchSpace> spaces = {own_space(volume)};
  const std::vector<Material> materials = materials_for(spaces);
  const RowNumbering numbering = own_rows(spaces);
  const Eigen::MatrixXd whole =
      dense(assemble_stiffness(spaces, whole_patches(spaces), materials, numbering));
  const double tolerance = round_off * whole.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  const std::vector<PatchLayers> both = {{0, 0, 2}, {0, 2, 5}};
  EXPECT_LT((dense(assemble_stiffness(spaces, both, materials, numbering)) - whole)
                .cwiseAbs()
                .maxCoeff<Eigen::PropagateNaN>(),
            tolerance);
  EXPECT_EQ(stiffness_pattern(spaces, both, numbering).columns,
            stiffness_pattern(spaces, whole_patches(spaces), numbering).columns);

  // As two processes do it: each numbers only the rows that its part touches, one of them backwards.
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(whole.rows(), whole.cols());
  const int plane = 12;
  for (const PatchLayers& part : both) {
    const int begin = plane * part.first_layer;
    const int end = plane * (part.last_layer + 2);  // two more planes of functions than layers
    RowNumbering local{std::vector<int>(numbering.row_of_node.size(), -1), end - begin};
    std::vector<int> node_of_row(static_cast<std::size_t>(end - begin));
    for (int node = begin; node < end; ++node) {
      const int row = part.first_layer == 0 ? node - begin : end - 1 - node;
      local.row_of_node[static_cast<std::size_t>(node)] = row;
      node_of_row[static_cast<std::size_t>(row)] = node;
    }
    const Eigen::MatrixXd own = dense(assemble_stiffness(spaces, {part}, materials, local));
    for (int r = 0; r < local.rows; ++r)
      for (int c = 0; c < local.rows; ++c)
        sum.block<3, 3>(3 * node_of_row[static_cast<std::size_t>(r)],
                        3 * node_of_row[static_cast<std::size_t>(c)]) += own.block<3, 3>(3 * r, 3 * c);
    EXPECT_EQ(stiffness_size(spaces, {part}, local).blocks,
              stiffness_pattern(spaces, {part}, local).blocks());
  }
  EXPECT_LT((sum - whole).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), tolerance);
}

TEST(SumFactorization, GivesTheSameBitsForAnyNumberOfThreadsAndAnyRows) {
  const NurbsVolume first = bent_cube(uniform({2, 2, 2}, {6, 4, 5}), true, 1);
  const NurbsVolume second = bent_cube(uniform({1, 2, 1}, {40, 3, 1}), false, 2);
  const std::vector<PatchSpace> spaces = {own_space(first), own_space(second)};
  const RowNumbering numbering = random_rows(spaces, 300, 8);
  const int usual = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = assemble_stiffness(spaces, whole_patches(spaces), materials_for(spaces), numbering);
  for (const int threads : {2, 3, 8}) {
    omp_set_num_threads(threads);
    const auto many = assemble_stiffness(spaces, whole_patches(spaces), materials_for(spaces), numbering);
    EXPECT_EQ(many.columns, one.columns);
    EXPECT_EQ(many.values, one.values) << threads;
  }
  omp_set_num_threads(usual);
}

TEST(SumFactorization, BalancesAffineStrainsOnAPatchOfSeveralChunks) {
  // The points of two layers take more than the 4 MB that are worked on at once.
  const NurbsVolume volume = bent_cube(uniform({1, 1, 1}, {70, 7, 70}), false, 6);
  const std::vector<PatchSpace> spaces = {own_space(volume)};
  const Material material = isotropic(1, 0.3);
  const auto matrix = assemble_stiffness(spaces, whole_patches(spaces), {material}, own_rows(spaces));
  Eigen::Matrix3d spin;
  spin << 0, -3, 2, 3, 0, -1, -2, 1, 0;
  const Eigen::Matrix3Xd rigid = (spin * volume.control_points()).colwise() + Eigen::Vector3d(1, 2, 3);
  const double scale = rigid.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() * solvers::mean_diagonal(matrix);
  EXPECT_LT(multiply(matrix, rigid.reshaped()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), round_off * scale);
  // Inside, the forces of a constant stress cancel.
  Eigen::Matrix3d stretch;
  stretch << 1, 0.2, 0.5, 0.2, -0.3, 0.1, 0.5, 0.1, 2;
  const Eigen::VectorXd force = multiply(matrix, (stretch * volume.control_points()).reshaped());
  const auto sizes = volume.sizes();
  for (int node = 0; node < volume.size(); ++node) {
    const int i = node % sizes[0], j = node / sizes[0] % sizes[1], k = node / sizes[0] / sizes[1];
    const bool inside = i > 0 && j > 0 && k > 0 && i < sizes[0] - 1 && j < sizes[1] - 1 && k < sizes[2] - 1;
    if (inside) {
      ASSERT_LT(force.segment<3>(3 * node).norm(), round_off * scale) << node;
    }
  }
}

TEST(SumFactorization, NamesAFoldInTheInputsOwnParameters) {
  Knots knots = uniform({1, 1, 1}, {4, 1, 1});
  Eigen::Matrix3Xd points = bent_cube(knots, false, 1).control_points();
  for (int node = 1; node < points.cols(); node += 5) points(0, node) = 0.6;  // beyond the next ones, at 0.5
  const NurbsVolume folded(knots, points);
  for (const bool reversed : {false, true}) {
    PatchSpace space = own_space(folded);
    space.reversed = reversed;
    try {
      assemble_stiffness({space}, whole_patches({space}), {isotropic(1, 0.3)}, own_rows({space}));
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::fold_over);
      // The second element has its Gauss points at 0.25 + 0.25 (0.211, 0.789).
      EXPECT_THAT(error.what(), ::testing::ContainsRegex(reversed ? "patch 0 .*parameter \\(0.(5528|6971)"
                                                                  : "patch 0 .*parameter \\(0.(3028|4471)"));
    }
  }
}

TEST(SumFactorization, RefusesNodesWithoutRows) {
  const NurbsVolume volume = bent_cube(uniform({1, 1, 1}, {2, 1, 1}), false, 1);
  const std::vector<PatchSpace> spaces = {own_space(volume)};
  for (const int row : {-1, 12}) {
    RowNumbering numbering = own_rows(spaces);
    numbering.row_of_node[7] = row;
    EXPECT_ERROR(assemble_stiffness(spaces, whole_patches(spaces), {isotropic(1, 0.3)}, numbering),
                 ErrorCode::invalid_argument, "node 7 has row");
  }
  EXPECT_ERROR(stiffness_pattern(spaces, {{0, 0, 2}}, own_rows(spaces)), ErrorCode::invalid_argument,
               "of patch 0, which has");
  EXPECT_ERROR(stiffness_pattern(spaces, {{1, 0, 1}}, own_rows(spaces)), ErrorCode::invalid_argument,
               "there is no patch 1");
  RowNumbering short_of_one = own_rows(spaces);
  short_of_one.row_of_node.pop_back();
  EXPECT_ERROR(stiffness_pattern(spaces, whole_patches(spaces), short_of_one), ErrorCode::invalid_argument,
               "the numbering has 11 nodes, the spaces have 12");
}

TEST(StiffnessSize, EqualsThePatternsWithoutBuildingIt) {
  const NurbsVolume first = bent_cube(uniform({2, 1, 3}, {2, 3, 2}), true, 1);
  const NurbsVolume second = bent_cube(
      {KnotVector::uniform(1, 3), KnotVector::uniform(2, 3, 2), KnotVector::uniform(2, 3)}, false, 2);
  const std::vector<PatchSpace> spaces = {own_space(first), own_space(second)};
  const int nodes = spaces[0].size() + spaces[1].size();
  for (const int rows : {nodes, nodes - 10, nodes / 2, 1}) {
    const RowNumbering numbering = random_rows(spaces, rows, 3);
    for (const std::vector<PatchLayers>& parts :
         {whole_patches(spaces), {{1, 0, 2}, {0, 1, 2}}, {{1, 0, 1}, {1, 2, 3}}, {}}) {
      const auto matrix = stiffness_pattern(spaces, parts, numbering);
      const StiffnessSize size = stiffness_size(spaces, parts, numbering);
      EXPECT_EQ(size.blocks, matrix.blocks());
      EXPECT_EQ(size.bytes, matrix.bytes());
      for (int row = 0; row < rows; ++row)
        EXPECT_EQ(matrix.columns[static_cast<std::size_t>(matrix.row_start[static_cast<std::size_t>(row)])],
                  row);
    }
  }
}

}  // namespace
}  // namespace isopatch::iga
