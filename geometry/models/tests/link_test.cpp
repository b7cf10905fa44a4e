#include "geometry/models/link.hpp"

#include <numbers>
#include <random>

#include "geometry/jacobian_certificate.hpp"
#include "geometry/measures.hpp"
#include "geometry/models/tests/model_checks.hpp"

namespace isopatch::geometry {
namespace {

using std::numbers::pi;

// Area of one end up to where the straight shank begins: outline above the axis, by sectors and triangles,
// twice.
double end_area(double bore, double outer, double half_width, double fillet) {
  const double height = half_width + fillet;
  const double reach = outer + fillet;
  const double angle = std::asin(height / reach);
  const double start = std::sqrt(reach * reach - height * height);
  return outer * outer * (pi - angle) + start * height - fillet * fillet * (pi / 2 - angle) -
         pi * bore * bore;
}

double shank_start(double outer, double half_width, double fillet) {
  return std::sqrt(std::pow(outer + fillet, 2) - std::pow(half_width + fillet, 2));
}

double closed_form_volume(const LinkOptions& o) {
  const double w = 0.5 * o.shank_width;
  const double straight = o.distance - shank_start(o.left_outer_radius, w, o.fillet_radius) -
                          shank_start(o.right_outer_radius, w, o.fillet_radius);
  return o.thickness *
         (end_area(o.left_bore_radius, o.left_outer_radius, w, o.fillet_radius) +
          end_area(o.right_bore_radius, o.right_outer_radius, w, o.fillet_radius) + straight * o.shank_width);
}

TEST(LinkModel, HasTheClosedFormsVolumeAndBoreAreas) {
  const LinkOptions options;
  const MultiPatch model = expect_sound(link_model(options), {11, 12, 42});
  const double expected = closed_form_volume(options);
  EXPECT_NEAR(total_volume(model), expected, quadrature_error * expected);
  EXPECT_NEAR(boundary_area(model, "bore_left"), 2 * pi * 10 * 12, 2 * pi * 10 * 12 * quadrature_error);
  EXPECT_NEAR(boundary_area(model, "bore_right"), 2 * pi * 7 * 12, 2 * pi * 7 * 12 * quadrature_error);
  EXPECT_NEAR(boundary_area(model, "top") * 12, expected, quadrature_error * expected);
}

TEST(LinkModel, BoresAndRoundEndsAreExact) {
  const MultiPatch model = expect_sound(link_model({.shank_patches = 3}), {13, 14, 50});
  const auto from_right = [](const Eigen::Vector3d& x) { return std::hypot(x.x() - 100, x.y()); };
  EXPECT_LE(worst(model, "bore_left", [](const Eigen::Vector3d& x) { return x.head<2>().norm() - 10; }),
            1e-14);
  EXPECT_LE(worst(model, "end_left", [](const Eigen::Vector3d& x) { return x.head<2>().norm() - 20; }),
            2e-14);
  // The coordinates themselves, near 100, are rounded to 1.4e-14.
  EXPECT_LE(worst(model, "bore_right", [&](const Eigen::Vector3d& x) { return from_right(x) - 7; }), 5e-14);
  EXPECT_LE(worst(model, "end_right", [&](const Eigen::Vector3d& x) { return from_right(x) - 14; }), 5e-14);
}

TEST(LinkModel, IsWellShaped) {
  for (const NurbsVolume& patch : link_model().patches) EXPECT_GT(quality(patch).min_scaled_jacobian, 0.7);
}

TEST(LinkModel, EveryAcceptedLinkIsCertified) {
  std::mt19937 random(11);
  const auto number = [&](double low, double high) { return low + (high - low) * random() / 4294967295.0; };
  int accepted = 0;
  for (int i = 0; i < 200; ++i) {
    LinkOptions o;
    o.left_outer_radius = number(5, 40);
    o.right_outer_radius = number(5, 40);
    o.left_bore_radius = number(0.05, 1) * o.left_outer_radius;
    o.right_bore_radius = number(0.05, 1) * o.right_outer_radius;
    o.shank_width = number(0.05, 2) * std::min(o.left_outer_radius, o.right_outer_radius);
    o.fillet_radius = std::pow(10, number(-1, 2));
    o.distance = number(50, 400);
    PatchSet patches;
    try {
      patches = link_model(o);
    } catch (const std::exception&) {
      continue;
    }
    ++accepted;
    for (std::size_t p = 0; p < patches.patches.size(); ++p)
      ASSERT_EQ(certify_jacobian(patches.patches[p]).sign, JacobianSign::positive)
          << "patch " << p << " left " << o.left_bore_radius << " " << o.left_outer_radius << " right "
          << o.right_bore_radius << " " << o.right_outer_radius << " shank " << o.shank_width << " fillet "
          << o.fillet_radius << " distance " << o.distance;
  }
  EXPECT_GT(accepted, 40);
}

TEST(LinkModel, RefusesOptionsOutsideTheirRange) {
  expect_refused([] { link_model({.thickness = -3}); }, {"link", "thickness is -3", "positive length"});
  expect_refused([] { link_model({.left_bore_radius = 20}); },
                 {"left_bore_radius is 20", "left_outer_radius, 20"});
  expect_refused([] { link_model({.shank_width = 28}); },
                 {"shank_width is 28", "twice the smaller outer radius"});
  expect_refused([] { link_model({.distance = 40}); }, {"distance is 40", "above 47.8", "fillet_radius"});
  expect_refused([] { link_model({.shank_width = 27, .fillet_radius = 0.1}); },
                 {"right_bore_radius is 7", "fillet_radius larger"});
  expect_refused([] { link_model({.shank_patches = 0}); }, {"shank_patches is 0"});
}

}  // namespace
}  // namespace isopatch::geometry
