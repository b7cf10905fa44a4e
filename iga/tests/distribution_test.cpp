#include "iga/distribution/distribution.hpp"

#include <gtest/gtest.h>

#include "iga/coupling/global_nodes.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;

KnotVector elements(int count, int degree = 2) {
  return KnotVector::uniform(degree, count);
}

PatchSpace space(int layers, int others = 4) {
  return {nullptr, {elements(others), elements(others), elements(layers)}, {}, false};
}

// Elements of each process, after a check that every element has exactly one.
std::vector<int> layers_of_processes(const std::vector<PatchSpace>& spaces, int processes) {
  const Distribution distribution = distribute(spaces, processes);
  EXPECT_EQ(distribution.size(), static_cast<std::size_t>(processes));
  std::vector<int> next(spaces.size(), 0), result;
  for (int process = 0; process < processes; ++process) {
    result.push_back(0);
    for (const PatchLayers& part : layers_of(distribution, spaces, process)) {
      EXPECT_EQ(part.first_layer, next[part.patch]);
      EXPECT_LT(part.first_layer, part.last_layer);
      next[part.patch] = part.last_layer;
      result.back() += part.last_layer - part.first_layer;
    }
  }
  for (std::size_t p = 0; p < spaces.size(); ++p) EXPECT_EQ(next[p], spaces[p].knots[2].element_count());
  return result;
}

TEST(Distribution, WholePatchesInOrderWhereTheyBalance) {
  const std::vector<PatchSpace> spaces(4, space(5));
  const Distribution distribution = distribute(spaces, 2);
  ASSERT_EQ(distribution[0].size(), 2u);
  EXPECT_EQ(distribution[0][1].patch, 1);
  EXPECT_EQ(distribution[1][0].patch, 2);
  EXPECT_EQ(distribution[0][0].end, 1);
}

TEST(Distribution, WholePatchesOutOfOrderWhereOrderDoesNotBalance) {
  const Distribution distribution = distribute({space(6), space(4), space(4), space(6)}, 2);
  ASSERT_EQ(distribution[0].size(), 2u);
  EXPECT_EQ(layers_of_processes({space(8), space(3), space(3), space(2)}, 2), (std::vector<int>{8, 8}));
}

TEST(Distribution, CutsPatchesBetweenLayers) {
  EXPECT_EQ(layers_of_processes({space(9)}, 3), (std::vector<int>{3, 3, 3}));
  EXPECT_EQ(layers_of_processes({space(8), space(8), space(8)}, 2), (std::vector<int>{12, 12}));
  EXPECT_EQ(layers_of_processes({space(7), space(7), space(7), space(7)}, 3), (std::vector<int>{9, 10, 9}));
}

TEST(Distribution, ProcessesBeyondTheLayersHaveNothing) {
  const std::vector<int> layers = layers_of_processes({space(2)}, 5);
  EXPECT_EQ(std::count(layers.begin(), layers.end(), 0), 3);
  EXPECT_EQ(layers_of_processes({space(1)}, 1), std::vector<int>{1});
}

TEST(Distribution, CountsTheWorkOfHigherDegrees) {
  PatchSpace high = space(4);
  high.knots = {elements(4, 5), elements(4, 5), elements(4, 5)};
  const Distribution distribution = distribute({high, space(4), space(4), space(4), space(4)}, 2);
  const std::vector<PatchLayers> parts =
      layers_of(distribution, {high, space(4), space(4), space(4), space(4)}, 0);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_LT(parts[0].last_layer, 4);
}

TEST(Distribution, CoarserSpacesAreCutAtTheSamePlaces) {
  const std::vector<PatchSpace> fine = {space(12)}, coarse = {space(6)};
  const Distribution distribution = distribute(fine, 2);
  EXPECT_EQ(layers_of(distribution, coarse, 0)[0].last_layer, 3);
  EXPECT_EQ(layers_of(distribution, coarse, 1)[0].first_layer, 3);
  EXPECT_EQ(processes_of_patches(distribution, 1)[0], (std::vector<int>{0, 1}));
}

TEST(Distribution, OneProcessHasAllRows) {
  const RowNumbering whole{{0, 1, 2, 1, 3}, 4};
  const LocalRows local = local_rows(whole, {0, 3, 5}, distribute({space(2), space(2)}, 1), {});
  EXPECT_EQ(local.numbering.row_of_node, whole.row_of_node);
  EXPECT_EQ(local.rows.local_rows(), 4);
  EXPECT_FALSE(local.rows.is_distributed());
}

}  // namespace
}  // namespace isopatch::iga
