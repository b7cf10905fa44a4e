#include "iga/estimate/refinement.hpp"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "geometry/base/tests/expect_error.hpp"
#include "iga/estimate/element_errors.hpp"
#include "iga/spaces/element_sheets.hpp"
#include "iga/spaces/patch_space.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

// 3 x 2 x 2 patches in random orientations, each of 2 x 2 x 2 elements.
geometry::MultiPatch turned_box() {
  return geometry::connect(geometry::box_model({.patches = {3, 2, 2}, .orientation_seed = 5}));
}

std::vector<std::array<int, 3>> elements_of(const Discretization& d) {
  std::vector<std::array<int, 3>> result;
  for (const geometry::NurbsVolume& patch : d.patches)
    result.push_back(
        {patch.knots(0).element_count(), patch.knots(1).element_count(), patch.knots(2).element_count()});
  return result;
}

std::vector<ElementErrors> no_errors(const Discretization& d) {
  std::vector<ElementErrors> errors;
  for (const auto& [u, v, w] : elements_of(d)) {
    const Eigen::Index count = Eigen::Index{u} * v * w;
    errors.push_back(
        {Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count), Eigen::Matrix3Xd::Zero(3, count)});
  }
  return errors;
}

TEST(ElementSheets, AreAllLayersOnce) {
  const Discretization d = discretize(turned_box(), {.refine = 1});
  const std::vector<ElementSheet> sheets = element_sheets(d);
  EXPECT_EQ(sheets.size(), 2u * (3 + 2 + 2));
  std::set<std::tuple<int, int, int>> layers;
  for (const ElementSheet& sheet : sheets)
    for (const ElementLayer& layer : sheet) layers.insert({layer.patch, layer.direction, layer.span});
  EXPECT_EQ(layers.size(), 12u * 3 * 2);
}

TEST(ElementSheets, AreWhatOneMoreKnotCuts) {
  const geometry::MultiPatch model = turned_box();
  const Discretization before = discretize(model, {.refine = 1});
  for (const ElementSheet& sheet : element_sheets(before)) {
    // A quarter of the way, so that a sheet with one layer the wrong way around would get another knot.
    const auto breaks =
        before.patches[static_cast<std::size_t>(sheet[0].patch)].knots(sheet[0].direction).breaks();
    const auto span = static_cast<std::size_t>(sheet[0].span);
    const double at = 0.75 * breaks[span] + 0.25 * breaks[span + 1];
    std::vector<std::array<int, 3>> expected = elements_of(before);
    for (const ElementLayer& layer : sheet)
      ++expected[static_cast<std::size_t>(layer.patch)][static_cast<std::size_t>(layer.direction)];
    EXPECT_EQ(
        elements_of(discretize(model, {.refine = 1, .knots = {{sheet[0].patch, sheet[0].direction, at}}})),
        expected);
  }
}

TEST(ElementSheets, MakeKnotsOfPlacesThatExist) {
  EXPECT_ERROR(discretize(turned_box(), {.knots = {{12, 0, 0.5}}}), ErrorCode::invalid_argument,
               "a knot in direction 0 of patch 12, of 12 patches");
  // A place where elements end already changes nothing.
  EXPECT_EQ(elements_of(discretize(turned_box(), {.refine = 1, .knots = {{3, 1, 0.5}}})),
            elements_of(discretize(turned_box(), {.refine = 1})));
}

TEST(Refinement, HalvesTheSheetThatHasTheError) {
  const Discretization d = discretize(turned_box(), {.degree = {2, 2, 2}, .refine = 1});
  std::vector<ElementErrors> errors = no_errors(d);
  errors[7].along(1, 5) = 3;  // element (1, 0, 1)
  const std::vector<KnotPlace> knots = knots_to_add(d, errors, 0.1, 4);
  ASSERT_EQ(knots.size(), 1u);
  const ElementSheet* sheet = nullptr;
  const std::vector<ElementSheet> sheets = element_sheets(d);
  for (const ElementSheet& one : sheets)
    for (const ElementLayer& layer : one)
      if (layer == ElementLayer{7, 1, 0}) sheet = &one;
  ASSERT_TRUE(sheet);
  const ElementLayer first = sheet->front();
  EXPECT_EQ(knots[0], (KnotPlace{first.patch, first.direction, first.span == 0 ? 0.25 : 0.75}));
}

// Degree 2 takes 15/16 of an error away.
TEST(Refinement, TakesTheBestFirstUntilEnoughIsPromised) {
  const Discretization d =
      discretize(geometry::connect(geometry::box_model({})), {.degree = {2, 2, 2}, .refine = 2});
  std::vector<ElementErrors> errors = no_errors(d);
  for (Eigen::Index i = 0; i < 4; ++i) errors[0].along(0, i) = 16 << i;  // 240 in all
  const auto places = [&](double wanted, double growth) {
    std::vector<double> result;
    for (const KnotPlace& knot : knots_to_add(d, errors, wanted, growth)) result.push_back(knot.parameter);
    return result;
  };
  EXPECT_EQ(places(241, 4), std::vector<double>{});
  EXPECT_EQ(places(121, 4), std::vector<double>{0.875});
  EXPECT_EQ(places(119, 4), (std::vector<double>{0.875, 0.625}));
  // All four would leave 15 of 240, and twice that is enough.
  EXPECT_EQ(places(0, 4).size(), 3u);
  // 6 functions along each direction: a knot adds a sixth.
  EXPECT_EQ(places(0, 1 + 2.1 / 6).size(), 2u);
  EXPECT_EQ(places(0, 1.01).size(), 1u);
}

// A displacement that is a polynomial of the raised degree along one direction and lower along the others.
TEST(Refinement, KnowsTheDirectionOfAnError) {
  const Discretization raised =
      discretize(geometry::connect(geometry::box_model({.size = {1, 2, 3}})), {.degree = {3, 3, 3}});
  for (int direction = 0; direction < 3; ++direction) {
    Eigen::Matrix3Xd error(3, 64);
    for (int i = 0; i < 64; ++i) {
      const std::array<int, 3> at = {i % 4, i / 4 % 4, i / 16};
      const double bump[4] = {0, 1, -1, 0};
      const auto d = static_cast<std::size_t>(direction);
      error.col(i).setConstant(bump[at[d]] * (1 + at[(d + 1) % 3]));  // linear along the next direction
    }
    const ElementErrors found =
        element_errors(raised, {testing::steel}, {error}, whole_patches(isoparametric_spaces(raised)),
                       solvers::Processes{})[0][0];
    EXPECT_GT(found.energy[0], 0);
    EXPECT_NEAR(found.along(direction, 0), found.energy[0], 1e-10 * found.energy[0]);
    EXPECT_NEAR(found.along.sum(), found.energy[0], 1e-12 * found.energy[0]);
  }
}

}  // namespace
}  // namespace isopatch::iga
