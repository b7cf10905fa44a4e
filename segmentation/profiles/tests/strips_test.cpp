#include "segmentation/profiles/internal/strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/profiles/tests/drawing.hpp"

namespace isopatch::segmentation::planar {
namespace {

/// A rectangle of 3 x 1 as columns side by side, divided at the shares of its long sides that are given.
struct Columns {
  Columns(const std::vector<double>& cuts) {
    drawings::Drawing drawing;
    drawing.region({drawing.rectangle(0, 0, 3, 1)});
    profile = drawing.profile;
    curves = curves_of(profile);
    for (const Eigen::Vector2d& vertex : profile.vertices) mesh.nodes.push_back({vertex, true, -1, 0});
    std::vector<double> at = {0};
    std::vector<int> below = {0}, above = {3};
    for (const double cut : cuts) {
      at.push_back(cut);
      below.push_back(node(0, cut));
      above.push_back(node(2, 1 - cut));
    }
    at.push_back(1);
    below.push_back(1);
    above.push_back(2);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      const bool first = i == 0, last = i + 2 == at.size();
      mesh.cells.push_back({0,
                            4,
                            {Side{below[i], below[i + 1], 0, at[i], at[i + 1]},
                             last ? Side{1, 2, 1} : Side{below[i + 1], above[i + 1]},
                             Side{above[i + 1], above[i], 2, 1 - at[i + 1], 1 - at[i]},
                             first ? Side{3, 0, 3} : Side{above[i], below[i]}}});
    }
  }
  int node(int curve, double at) {
    mesh.nodes.push_back({curves[static_cast<std::size_t>(curve)].at(at), false, curve, at});
    return static_cast<int>(mesh.nodes.size()) - 1;
  }
  SearchInput input() const {
    return {ShapeRules(QuadrangulationOptions()), curves, shared_none(), CutPlaces(curves.size())};
  }
  std::vector<bool> shared_none() const { return std::vector<bool>(curves.size(), false); }

  Profile profile;
  std::vector<Curve> curves;
  CellMesh mesh;
};

double width(const CellMesh& mesh, const Cell& cell) {
  return std::abs(mesh.nodes[static_cast<std::size_t>(cell.sides[0].to)].point.x() -
                  mesh.nodes[static_cast<std::size_t>(cell.sides[0].from)].point.x());
}

TEST(Strips, RunFromOutlineToOutline) {
  const Columns columns({0.2, 0.6});
  const std::vector<Strip> strips = strips_of(columns.mesh);
  ASSERT_EQ(strips.size(), 4U);  // three across and one along
  std::vector<std::size_t> rungs;
  for (const Strip& strip : strips) rungs.push_back(strip.rungs.size());
  std::sort(rungs.begin(), rungs.end());
  EXPECT_EQ(rungs, (std::vector<std::size_t>{2, 2, 2, 4}));
}

TEST(Strips, CutsMeetInTheMiddleAndAtVertices) {
  const Columns columns({0.2, 0.6});
  int taken_out = 0;
  for (const Strip& strip : strips_of(columns.mesh)) {
    const auto without = without_strip(columns.curves, columns.mesh, strip);
    if (strip.rungs.size() == 4) {
      EXPECT_FALSE(without);  // vertices of the profile would meet
      continue;
    }
    ASSERT_TRUE(without);
    ++taken_out;
    ASSERT_EQ(without->cells.size(), 2U);
    double sum = 0;
    for (const Cell& cell : without->cells) {
      sum += width(*without, cell);
      EXPECT_NEAR(cell.sides[0].high - cell.sides[0].low, width(*without, cell) / 3, 1e-12);
    }
    EXPECT_NEAR(sum, 3, 1e-12);
    // Between columns is now the middle of the one taken out, or the cut that stayed.
    const double first = width(*without, without->cells.front());
    EXPECT_TRUE(std::abs(first - 1.2) < 1e-12 || std::abs(first - 1.8) < 1e-12 ||
                std::abs(first - 0.6) < 1e-12)
        << first;
  }
  EXPECT_EQ(taken_out, 3);
}

TEST(Strips, AreTakenOutUntilNoneIsLeftToSpare) {
  const Columns columns({0.1, 0.3, 0.5, 0.55});
  const CellMesh mesh = with_fewer_strips(columns.input(), columns.mesh, 0);
  ASSERT_EQ(mesh.cells.size(), 1U);
  std::set<int> corners;
  for (const Side& side : mesh.cells.front().sides) corners.insert(side.from);
  EXPECT_EQ(corners, (std::set<int>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace isopatch::segmentation::planar
