#include "iga/distribution/shared_interfaces.hpp"

#include <gtest/gtest.h>

#include <set>

#include "geometry/models/box.hpp"

namespace isopatch::iga {
namespace {

using geometry::box_model;

// A row of four boxes below three, and far away one on two.
geometry::MultiPatch two_piles() {
  const auto join = [](std::vector<geometry::PatchSet> sets) {
    geometry::PatchSet result = std::move(sets.front());
    for (std::size_t i = 1; i < sets.size(); ++i)
      result.patches.insert(result.patches.end(), sets[i].patches.begin(), sets[i].patches.end());
    return result;
  };
  return geometry::connect(join({box_model({.size = {4, 1, 1}, .patches = {4, 1, 1}}),
                                 box_model({.size = {4, 1, 1}, .origin = {0, 0, 1}, .patches = {3, 1, 1}}),
                                 box_model({.size = {2, 1, 1}, .origin = {9, 0, 0}, .patches = {1, 1, 1}}),
                                 box_model({.size = {2, 1, 1}, .origin = {9, 0, 1}, .patches = {2, 1, 1}})}),
                           {.keep_non_matching = true});
}

struct Shared {
  explicit Shared(int processes)
      : model(two_piles()), d(discretize(model, {.degree = {2, 2, 2}, .refine = 1})) {
    spaces = isoparametric_spaces(d);
    distribution = distribute(d.model, spaces, global_nodes(d), processes);
  }
  geometry::MultiPatch model;
  Discretization d;
  std::vector<PatchSpace> spaces;
  Distribution distribution;

  // The processes that tie a patch.
  std::set<std::size_t> tying(int patch) const {
    std::set<std::size_t> result;
    for (std::size_t process = 0; process < distribution.size(); ++process)
      for (const PatchShare& share : distribution[process])
        if (share.patch == patch && share.couples) result.insert(process);
    return result;
  }
};

TEST(SharedInterfaces, EachPileHasOneProcess) {
  for (const int processes : {2, 3, 5}) {
    const Shared shared(processes);
    for (int patch = 0; patch < 10; ++patch) {
      const std::set<std::size_t> of_patch = shared.tying(patch);
      EXPECT_EQ(of_patch.size(), 1u) << patch;
      EXPECT_EQ(of_patch, shared.tying(patch < 7 ? 0 : 7)) << patch;
    }
  }
}

TEST(SharedInterfaces, NothingIsIntegratedTwice) {
  const Shared shared(3);
  std::vector<int> layers(shared.spaces.size(), 0);
  for (int process = 0; process < 3; ++process)
    for (const PatchLayers& part : layers_of(shared.distribution, shared.spaces, process))
      layers[static_cast<std::size_t>(part.patch)] += part.last_layer - part.first_layer;
  for (std::size_t p = 0; p < layers.size(); ++p)
    EXPECT_EQ(layers[p], shared.spaces[p].knots[2].element_count());
}

// It acts for a patch where vectors are moved between levels, so it must have something of it.
TEST(SharedInterfaces, PrimaryProcessesIntegrate) {
  const Shared shared(3);
  const auto of_patch = processes_of_patches(shared.distribution, static_cast<int>(shared.spaces.size()));
  for (std::size_t p = 0; p < of_patch.size(); ++p) {
    const auto& shares = shared.distribution[static_cast<std::size_t>(of_patch[p].front())];
    EXPECT_TRUE(std::any_of(shares.begin(), shares.end(), [&](const PatchShare& share) {
      return share.patch == static_cast<int>(p) && !share.is_empty();
    }));
  }
}

TEST(SharedInterfaces, OneProcessHasAll) {
  const Shared shared(1);
  for (int patch = 0; patch < 10; ++patch) EXPECT_EQ(shared.tying(patch), std::set<std::size_t>{0});
}

}  // namespace
}  // namespace isopatch::iga
