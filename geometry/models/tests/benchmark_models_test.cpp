#include <numbers>

#include "geometry/models/elliptic_plate.hpp"
#include "geometry/models/tests/model_checks.hpp"
#include "geometry/models/twisted_beam.hpp"

namespace isopatch::geometry {
namespace {

using std::numbers::pi;

TEST(EllipticPlateModel, HasExactEllipsesAndTheClosedFormsVolume) {
  for (const int layers : {1, 2, 3}) {
    SCOPED_TRACE(layers);
    const MultiPatch model =
        expect_sound(elliptic_plate_model({.layers = layers}), {layers, layers - 1, 4 * layers + 2});
    const double section = pi / 4 * (3.25 * 2.75 - 2 * 1);
    EXPECT_NEAR(total_volume(model), 0.6 * section, 0.6 * section * quadrature_error);
    EXPECT_NEAR(boundary_area(model, "bottom"), section, section * quadrature_error);
    EXPECT_NEAR(boundary_area(model, "top"), section, section * quadrature_error);
    EXPECT_NEAR(boundary_area(model, "y_min"), 0.6 * 1.25, round_off);
    EXPECT_NEAR(boundary_area(model, "x_min"), 0.6 * 1.75, round_off);
    const auto off = [](double a, double b) {
      return [=](const Eigen::Vector3d& x) { return std::hypot(x[0] / a, x[1] / b) - 1; };
    };
    EXPECT_LE(worst(model, "inner", off(2, 1)), 1e-15);
    EXPECT_LE(worst(model, "outer", off(3.25, 2.75)), 1e-15);
    EXPECT_LE(worst(model, "x_min", [](const Eigen::Vector3d& x) { return x[0]; }), 1e-15);
    EXPECT_LE(worst(model, "top", [](const Eigen::Vector3d& x) { return x[2] - 0.6; }), 1e-15);
  }
}

TEST(EllipticPlateModel, RefusesEllipsesThatDoNotFit) {
  expect_refused([] { elliptic_plate_model({.outer_y = 1}); },
                 {"elliptic_plate", "inner_y is 1", "below outer_y, 1"});
  expect_refused([] { elliptic_plate_model({.inner_x = -2}); }, {"inner_x is -2", "positive length"});
  expect_refused([] { elliptic_plate_model({.layers = 0}); }, {"layers is 0"});
}

TEST(TwistedBeamModel, TurnsEvenlyWithinItsTolerance) {
  for (const double degrees : {90.0, 3.0, 400.0}) {
    SCOPED_TRACE(degrees);
    const TwistedBeamOptions options = {.twist = Angle::degrees(degrees)};
    const MultiPatch model = expect_sound(twisted_beam_model(options), {1, 0, 6});
    // Sections scaled by 1 + 1e-6 at most.
    EXPECT_NEAR(total_volume(model), 12 * 1.1 * 0.32, 12 * 1.1 * 0.32 * 2e-6);
    EXPECT_NEAR(boundary_area(model, "root"), 1.1 * 0.32, round_off);
    EXPECT_NEAR(boundary_area(model, "tip"), 1.1 * 0.32, round_off);
    const NurbsVolume& beam = model.patch(PatchId(0));
    for (int i = 0; i <= 500; ++i) {
      const double t = i / 500.0;
      const double angle = t * options.twist.radians();
      const Eigen::Vector3d exact(12 * t, 0.55 * std::cos(angle) - 0.16 * std::sin(angle),
                                  0.55 * std::sin(angle) + 0.16 * std::cos(angle));
      const double allowed = i == 0 || i == 500 ? 1e-14 : 1e-6 * std::hypot(0.55, 0.16);
      EXPECT_LE((beam.point({t, 1, 1}) - exact).norm(), allowed) << t;
    }
  }
}

TEST(TwistedBeamModel, RefusesOptionsOutsideTheirRange) {
  expect_refused([] { twisted_beam_model({.depth = 0}); }, {"twisted_beam", "depth is 0", "positive length"});
  expect_refused([] { twisted_beam_model({.twist = Angle::degrees(721)}); }, {"twist"});
}

}  // namespace
}  // namespace isopatch::geometry
