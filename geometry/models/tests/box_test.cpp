#include "geometry/models/box.hpp"

#include "geometry/jacobian_certificate.hpp"
#include "geometry/measures.hpp"
#include "geometry/models/tests/model_checks.hpp"

namespace isopatch::geometry {
namespace {

// A grid of n x m x k patches.
Expected grid(int n, int m, int k) {
  return {n * m * k, (n - 1) * m * k + n * (m - 1) * k + n * m * (k - 1), 2 * (n * m + m * k + n * k)};
}

TEST(BoxModel, IsTheBoxAskedFor) {
  const MultiPatch model = expect_sound(
      box_model({.size = {2, 3, 5}, .origin = {-1, 7, 0.5}, .patches = {2, 3, 1}}), grid(2, 3, 1));
  EXPECT_NEAR(total_volume(model), 30, 30 * round_off);
  EXPECT_NEAR(boundary_area(model, "y_max"), 10, 10 * round_off);
  EXPECT_EQ(worst(model, "x_min", [](const Eigen::Vector3d& x) { return x.x() + 1; }), 0);
  // Two units of the last place of 10.
  EXPECT_LE(worst(model, "y_max", [](const Eigen::Vector3d& x) { return x.y() - 10; }), 4e-15);
  EXPECT_LE(worst(model, "z_max", [](const Eigen::Vector3d& x) { return x.z() - 5.5; }), 4e-15);
}

TEST(BoxModel, DistortionAndCurvatureKeepTheOuterBox) {
  const MultiPatch model = expect_sound(
      box_model({.size = {1, 2, 3}, .patches = {2, 2, 2}, .distortion = 0.3, .curvature = 0.25, .seed = 5}),
      grid(2, 2, 2));
  EXPECT_NEAR(total_volume(model), 6, 6 * round_off);
  EXPECT_NEAR(boundary_area(model, "x_max"), 6, 6 * round_off);
  EXPECT_NEAR(boundary_area(model, "z_min"), 2, 2 * round_off);
  EXPECT_LE(worst(model, "x_max", [](const Eigen::Vector3d& x) { return x.x() - 1; }), 1e-15);
}

TEST(BoxModel, DistortionMovesInnerAndOuterCornersOnlyAsTold) {
  const auto middle = [](const BoxOptions& options) {
    return Eigen::Vector3d(box_model(options).patches[0].control_points().col(7));
  };
  const auto face_middle = [](const BoxOptions& options) {
    return Eigen::Vector3d(box_model(options).patches[0].control_points().col(3));
  };
  const Eigen::Vector3d center(0.5, 0.5, 0.5);
  BoxOptions options = {.patches = {2, 2, 2}, .distortion = 0.4};
  // Between a quarter and a half of distortion times the patch size 1/2, in each direction at most.
  EXPECT_GE((middle(options) - center).norm(), 0.05);
  EXPECT_LE((middle(options) - center).norm(), 0.1);
  EXPECT_NE(face_middle(options), Eigen::Vector3d(0.5, 0.5, 0));
  EXPECT_EQ(face_middle(options).z(), 0);
  options.distort_faces = false;
  EXPECT_EQ(face_middle(options), Eigen::Vector3d(0.5, 0.5, 0));
  EXPECT_NE(middle(options), center);
}

TEST(BoxModel, EverySeedAtTheLimitsIsCertified) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const BoxOptions straight = {.patches = {2, 3, 2}, .distortion = 0.55, .seed = seed};
    const BoxOptions curved = {.patches = {2, 2, 2}, .distortion = 0.2, .curvature = 0.35, .seed = seed};
    for (const BoxOptions& options : {straight, curved})
      for (const NurbsVolume& patch : box_model(options).patches)
        ASSERT_EQ(certify_jacobian(patch).sign, JacobianSign::positive) << "seed " << seed;
  }
}

TEST(BoxModel, CurvatureMakesInterfacesThatAreNotFlat) {
  const PatchSet patches = box_model({.patches = {2, 1, 1}, .curvature = 0.4});
  const NurbsSurface shared = face_surface(patches.patches[0], Side::east);
  const Eigen::Matrix3Xd& points = shared.control_points();
  EXPECT_GT(points.row(0).maxCoeff<Eigen::PropagateNaN>() - points.row(0).minCoeff<Eigen::PropagateNaN>(),
            0.02);
}

TEST(BoxModel, SeedsAreReproducible) {
  const BoxOptions options = {.patches = {2, 2, 2}, .distortion = 0.3, .seed = 3};
  BoxOptions other = options;
  other.seed = 4;
  const auto first_patch = [](const BoxOptions& o) { return box_model(o).patches[0].control_points(); };
  EXPECT_EQ(first_patch(options), first_patch(options));
  EXPECT_NE(first_patch(options), first_patch(other));
  // Pinned, so that a study's figures stay the same from machine to machine and version to version.
  const Eigen::Vector3d pinned(0.45875817540800201, 0.47236508725909515, 0.48597798756090926);
  EXPECT_LE((first_patch(options).col(7) - pinned).norm(), 1e-15);
}

TEST(BoxModel, RandomOrientationsAreTheSameBody) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const MultiPatch model = expect_sound(
        box_model({.patches = {3, 2, 2}, .distortion = 0.3, .curvature = 0.2, .orientation_seed = seed}),
        grid(3, 2, 2));
    EXPECT_NEAR(total_volume(model), 1, round_off);
    EXPECT_LE(worst(model, "y_max", [](const Eigen::Vector3d& x) { return x.y() - 1; }), 1e-15);
  }
}

TEST(BoxModel, RefusesOptionsOutsideTheirRange) {
  expect_refused([] { box_model({.size = {1, -2, 1}}); }, {"box", "size along y is -2", "positive length"});
  expect_refused([] { box_model({.patches = {1, 1, 0}}); }, {"patches along z is 0", "1 to 1000"});
  expect_refused(
      [] {
        box_model({.patches = {1000, 1000, 2}});
      },
      {"number of all patches is 2000000", "100000"});
  expect_refused([] { box_model({.distortion = 0.6}); }, {"distortion is 0.6", "between 0 and 0.55"});
  expect_refused([] { box_model({.curvature = -0.1}); }, {"curvature is -0.1", "between 0 and 0.55"});
  expect_refused([] { box_model({.distortion = 0.4, .curvature = 0.3}); },
                 {"distortion + curvature is 0.7", "0.55"});
  expect_refused([] { box_model({.origin = {0, NAN, 0}}); }, {"origin along y is nan"});
}

}  // namespace
}  // namespace isopatch::geometry
