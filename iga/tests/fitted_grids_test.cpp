// Straight cells between whose nodes von Mises stress is what the solution has.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/larger.hpp"
#include "geometry/splines/refine.hpp"
#include "iga/output/fitted_grids.hpp"
#include "iga/output/output_grid.hpp"
#include "iga/output/plane_fields.hpp"
#include "iga/output/surface_points.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::GridParameters;
using geometry::MultiPatch;
using geometry::NurbsVolume;

struct Model {
  MultiPatch patches;
  ElasticField field;
};

// Boxes of degree 2 with coefficients from their control points.
Model displaced(const geometry::BoxOptions& options, const auto& displacement) {
  Model model{geometry::connect(geometry::box_model(options)), {}};
  model.field.patches = discretize(model.patches, {.degree = {3, 3, 3}, .refine = 1}).patches;
  model.field.materials.assign(model.field.patches.size(), isotropic(1e9, 0));
  for (const NurbsVolume& patch : model.field.patches) {
    Eigen::Matrix3Xd u = patch.control_points();
    for (Eigen::Index i = 0; i < u.cols(); ++i) u.col(i) = displacement(Eigen::Vector3d(u.col(i)));
    model.field.displacement.push_back(u);
  }
  return model;
}

std::vector<GridParameters<3>> grids_with(const Model& model, int pieces) {
  std::vector<GridParameters<3>> result;
  const auto all = straight_pieces(model.patches, model.field.patches, pieces);
  for (std::size_t p = 0; p < all.size(); ++p) result.push_back(grid_of(model.field.patches[p], all[p]));
  return result;
}

// The largest difference of interpolated von Mises stress at 5 x 5 x 5 points of every cell, of the largest.
double worst_between(const ElasticField& field, const std::vector<GridParameters<3>>& grids) {
  double worst = 0, largest = 0;
  for (std::size_t p = 0; p < grids.size(); ++p) {
    const auto& [x, y, z] = grids[p];
    const auto stress = [&](double u, double v, double w) {
      const double value = evaluate(field, static_cast<int>(p), {u, v, w}).von_mises;
      largest = isopatch::larger(largest, value);
      return value;
    };
    for (std::size_t k = 0; k + 1 < z.size(); ++k)
      for (std::size_t j = 0; j + 1 < y.size(); ++j)
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
          std::array<double, 8> corners{};
          for (std::size_t c = 0; c < 8; ++c)
            corners[c] = stress(x[i + (c & 1)], y[j + (c >> 1 & 1)], z[k + (c >> 2)]);
          for (int s = 0; s < 125; ++s) {
            const Eigen::Array3d t(0.25 * (s % 5), 0.25 * (s / 5 % 5), 0.25 * (s / 25));
            double shown = 0;
            for (std::size_t c = 0; c < 8; ++c)
              shown += corners[c] * ((c & 1) ? t[0] : 1 - t[0]) * ((c >> 1 & 1) ? t[1] : 1 - t[1]) *
                       ((c >> 2) ? t[2] : 1 - t[2]);
            const double right = stress(x[i] + t[0] * (x[i + 1] - x[i]), y[j] + t[1] * (y[j + 1] - y[j]),
                                        z[k] + t[2] * (z[k + 1] - z[k]));
            worst = isopatch::larger(worst, std::abs(shown - right));
          }
        }
  }
  return worst / largest;
}

// Stretched along y by a strain that changes its sign near y = 0.37.
Eigen::Vector3d bent(const Eigen::Vector3d& x) {
  return {0, 0.5e-3 * (x[1] - 0.37) * (x[1] - 0.37), 0};
}

TEST(FittedGrids, AreFineWhereStressVanishes) {
  const Model model = displaced({}, bent);
  std::vector<GridParameters<3>> grids = grids_with(model, 4);
  const std::vector<GridParameters<3>> before = grids;
  EXPECT_GT(worst_between(model.field, grids), 0.02);
  const FitReport report = fit_grids(model.field, model.patches, {}, grids);
  EXPECT_LT(worst_between(model.field, grids), 0.01);
  EXPECT_LE(report.off, 0.01);
  // The stress depends on y alone.
  EXPECT_EQ(grids[0][0], before[0][0]);
  EXPECT_EQ(grids[0][2], before[0][2]);
  const std::vector<double>& y = grids[0][1];
  EXPECT_THAT(y, ::testing::IsSupersetOf(before[0][1]));
  EXPECT_LE(y.size(), before[0][1].size() + 5);
  EXPECT_EQ(report.cells, std::int64_t{8 * 8} * static_cast<std::int64_t>(y.size() - 1));
}

TEST(FittedGrids, AreFineWhereStressIsCurved) {
  // A stress like x^2 from 0 to the largest: at 2 x 2 pieces off by a sixteenth of a half.
  const Model model = displaced(
      {}, [](const Eigen::Vector3d& x) { return Eigen::Vector3d(1e-3 * x[0] * x[0] * x[0], 0, 0); });
  std::vector<GridParameters<3>> grids = grids_with(model, 2);
  EXPECT_GT(worst_between(model.field, grids), 0.012);
  fit_grids(model.field, model.patches, {}, grids);
  EXPECT_LT(worst_between(model.field, grids), 0.01);
}

TEST(FittedGrids, MeetNodeByNode) {
  const Model model =
      displaced({.patches = {2, 2, 2}, .distortion = 0.2, .curvature = 0.2, .orientation_seed = 3}, bent);
  std::vector<GridParameters<3>> grids = grids_with(model, 3);
  const std::size_t before = grids[0][0].size();
  EXPECT_GT(worst_between(model.field, grids), 0.02);
  const FitReport report = fit_grids(model.field, model.patches, {}, grids);
  EXPECT_LE(report.off, 0.01);
  EXPECT_LT(worst_between(model.field, grids), 0.01);
  EXPECT_GT(grids[0][0].size() + grids[0][1].size() + grids[0][2].size(), 3 * before);
  const SurfacePoints surface(model.patches, model.field.patches, grids);
  for (const geometry::Interface& interface : model.patches.interfaces()) {
    const auto points = [&](const geometry::PatchFace& face) {
      const Eigen::Matrix3Xd all = surface.face(face.patch.value, face.side);
      std::vector<std::array<double, 3>> sorted;
      for (Eigen::Index i = 0; i < all.cols(); ++i) sorted.push_back({all(0, i), all(1, i), all(2, i)});
      std::sort(sorted.begin(), sorted.end());
      return sorted;
    };
    EXPECT_EQ(points(interface.first), points(interface.second));
  }
}

TEST(FittedGrids, KeepToTheLimitAndSayWhatIsOff) {
  const Model model = displaced({}, bent);
  std::vector<GridParameters<3>> grids = grids_with(model, 4);
  const std::vector<GridParameters<3>> before = grids;
  const FitReport report = fit_grids(model.field, model.patches, {.most_cells = 100}, grids);
  EXPECT_EQ(grids, before);
  EXPECT_GT(report.off, 0.02);
  EXPECT_EQ(report.patch, 0);
  EXPECT_NEAR(report.place[1], 0.37, 0.1);  // a cell is 0.125
}

TEST(FittedGrids, OfNoStressAreNotChanged) {
  const Model model = displaced({}, [](const Eigen::Vector3d&) { return Eigen::Vector3d(1, 0, 0); });
  std::vector<GridParameters<3>> grids = grids_with(model, 1);
  const std::vector<GridParameters<3>> before = grids;
  EXPECT_EQ(fit_grids(model.field, model.patches, {}, grids).off, 0);
  EXPECT_EQ(grids, before);
}

}  // namespace
}  // namespace isopatch::iga
