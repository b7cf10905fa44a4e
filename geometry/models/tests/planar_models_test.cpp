#include <numbers>

#include "geometry/models/bracket.hpp"
#include "geometry/models/cook.hpp"
#include "geometry/models/plate.hpp"
#include "geometry/models/tests/model_checks.hpp"

namespace isopatch::geometry {
namespace {

using std::numbers::pi;

TEST(PlateModel, HasAnExactHoleAndTheClosedFormsVolume) {
  for (const auto& [width, height] : {std::pair{4.0, 4.0}, std::pair{5.0, 1.5}, std::pair{1.1, 20.0}}) {
    SCOPED_TRACE(width / height);
    const PlateOptions options = {.width = width, .height = height, .hole_radius = 1, .thickness = 0.5};
    const MultiPatch model = expect_sound(plate_model(options), {2, 1, 10});
    const double expected = 0.5 * (width * height - pi / 4);
    EXPECT_NEAR(total_volume(model), expected, quadrature_error * expected);
    EXPECT_NEAR(boundary_area(model, "hole"), 0.25 * pi, 0.25 * pi * quadrature_error);
    EXPECT_NEAR(boundary_area(model, "x_max"), 0.5 * height, height * round_off);
    EXPECT_NEAR(boundary_area(model, "x_min"), 0.5 * (height - 1), height * round_off);
    EXPECT_LE(worst(model, "hole", [](const Eigen::Vector3d& x) { return x.head<2>().norm() - 1; }), 1e-15);
    EXPECT_LE(worst(model, "x_min", [](const Eigen::Vector3d& x) { return x.x(); }), 1e-15);
    EXPECT_EQ(worst(model, "y_min", [](const Eigen::Vector3d& x) { return x.y(); }), 0);
  }
}

TEST(PlateModel, RefusesAHoleThatDoesNotFit) {
  expect_refused([] { plate_model({.height = 1}); }, {"plate", "hole_radius is 1", "below height, 1"});
  expect_refused([] { plate_model({.width = 0.5}); }, {"hole_radius is 1", "below width, 0.5"});
  expect_refused([] { plate_model({.thickness = NAN}); }, {"thickness is nan", "positive length"});
}

TEST(BracketModel, IsThreeBricks) {
  const MultiPatch model = expect_sound(bracket_model(), {3, 2, 14});
  EXPECT_NEAR(total_volume(model), 3, 3 * round_off);
  EXPECT_NEAR(boundary_area(model, "inner"), 2, 2 * round_off);
  EXPECT_NEAR(boundary_area(model, "x_min"), 2, 2 * round_off);
  EXPECT_NEAR(boundary_area(model, "y_max"), 1, round_off);
  EXPECT_NEAR(surface_area(model), 2 * 3 + 8, 14 * round_off);
  EXPECT_EQ(worst(model, "y_max", [](const Eigen::Vector3d& x) { return x.y() - 2; }), 0);
}

TEST(BracketModel, RefusesOptionsOutsideTheirRange) {
  expect_refused([] { bracket_model({.width = 2}); }, {"bracket", "width is 2", "below leg, 2"});
  expect_refused([] { bracket_model({.leg = -1}); }, {"leg is -1", "positive length"});
}

TEST(CookModel, HasTheClassicDimensions) {
  const MultiPatch model = expect_sound(cook_model({.patches = {3, 2}}), {6, 7, 22});
  EXPECT_NEAR(total_volume(model), 1440, 1440 * round_off);
  EXPECT_NEAR(boundary_area(model, "x_min"), 44, 44 * round_off);
  EXPECT_NEAR(boundary_area(model, "x_max"), 16, 16 * round_off);
  EXPECT_NEAR(boundary_area(model, "y_min"), std::hypot(48, 44), 65 * round_off);
  EXPECT_NEAR(boundary_area(model, "y_max"), std::hypot(48, 16), 51 * round_off);
}

TEST(CookModel, RefusesOptionsOutsideTheirRange) {
  expect_refused([] { cook_model({.right_height = 0}); }, {"cook", "right_height is 0", "positive length"});
  expect_refused([] { cook_model({.rise = INFINITY}); }, {"rise is inf"});
  expect_refused([] { cook_model({.patches = {1, 0}}); }, {"patches along y is 0"});
}

}  // namespace
}  // namespace isopatch::geometry
