#include "geometry/base/union_find.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace isopatch {
namespace {

TEST(UnionFind, TheSmallestMemberRepresentsItsSet) {
  UnionFind sets(6);
  EXPECT_TRUE(sets.unite(5, 3));
  EXPECT_TRUE(sets.unite(4, 5));
  EXPECT_FALSE(sets.unite(3, 4));
  EXPECT_EQ(sets.find(4), 3);
  EXPECT_EQ(sets.find(2), 2);
  EXPECT_EQ(sets.set_count(), 4);
  EXPECT_TRUE(sets.unite(1, 4));
  for (const int i : {1, 3, 4, 5}) EXPECT_EQ(std::as_const(sets).find(i), 1);
}

TEST(SignedUnionFind, SensesAddUpAlongChains) {
  // Each number has a hidden sense; chains in random order must find it again.
  constexpr int count = 200;
  std::mt19937 random(5);
  std::vector<bool> sense;
  for (int i = 0; i < count; ++i) sense.push_back(random() % 2 == 0);
  const auto against = [&](int i, int j) {
    return sense[static_cast<std::size_t>(i)] != sense[static_cast<std::size_t>(j)];
  };
  SignedUnionFind sets(count);
  for (int k = 0; k < 10 * count; ++k) {
    const int i = static_cast<int>(random() % count), j = static_cast<int>(random() % count);
    EXPECT_TRUE(sets.unite(i, j, against(i, j)));
  }
  for (int i = 0; i < count; ++i) {
    const SignedUnionFind::Member found = sets.find(i);
    EXPECT_EQ(std::as_const(sets).find(i), found);
    EXPECT_LE(found.root, i);
    EXPECT_EQ(found.against, against(found.root, i));
  }
}

TEST(SignedUnionFind, SaysWhereAMemberMeetsItselfTurnedAround) {
  SignedUnionFind sets(3);
  EXPECT_TRUE(sets.unite(0, 1, true));
  EXPECT_TRUE(sets.unite(1, 2, false));
  EXPECT_TRUE(sets.unite(2, 0, true));
  EXPECT_FALSE(sets.unite(0, 2, false));
  EXPECT_FALSE(sets.unite(1, 1, true));
  EXPECT_EQ(sets.find(2), (SignedUnionFind::Member{0, true}));
}

}  // namespace
}  // namespace isopatch
