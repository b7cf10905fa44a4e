#include "geometry/touching_boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace isopatch::geometry {
namespace {

TEST(TouchingBoxes, AreThosePairsThatAreNear) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto point = [&] { return Eigen::Vector3d(uniform(random), uniform(random), uniform(random)); };
  std::vector<Eigen::AlignedBox3d> boxes;
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d corner = point();
    boxes.emplace_back(corner, corner + 0.3 * point());
  }
  for (const double distance : {0.0, 0.1}) {
    std::vector<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size(); ++j)
        if (boxes[i].exteriorDistance(boxes[j]) <= distance) expected.emplace_back(i, j);
    auto found = touching_boxes(boxes, distance);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    EXPECT_GT(expected.size(), 20u);
    EXPECT_LT(expected.size(), 1000u);
  }
}

}  // namespace
}  // namespace isopatch::geometry
