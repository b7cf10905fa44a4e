#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "app/pictures/clip.hpp"
#include "app/pictures/part_shape.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/measures.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"

namespace isopatch::app {
namespace {

double area(const Surface& surface) {
  double sum = 0;
  for (const auto& triangle : surface.triangles) sum += area_vector(surface, triangle).norm() / 2;
  return sum;
}

double length(const Lines& lines) {
  double sum = 0;
  for (const auto& [a, b] : lines.segments) sum += (lines.points.col(a) - lines.points.col(b)).norm();
  return sum;
}

/// Two by one by one cubes in a row, oriented at random.
geometry::MultiPatch two_cubes() {
  return geometry::connect(
      geometry::box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}, .orientation_seed = 3}));
}

std::vector<PatchShape> shape_of(const geometry::MultiPatch& model,
                                 PictureField field = PictureField::patch) {
  return part_shape(iga::sample_part(model, model.patches()), {.field = field, .component = {}});
}

TEST(PartShape, TheOuterSurfaceIsClosedAndHasTheAreaOfTheFaces) {
  const auto model = two_cubes();
  const Surface surface = outer_surface(model, shape_of(model));
  EXPECT_NEAR(area(surface), 10, 1e-12);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double volume = 0;  // the divergence theorem; negative if the triangles faced inwards
  for (const auto& triangle : surface.triangles) {
    sum += area_vector(surface, triangle);
    volume += area_vector(surface, triangle).dot(surface.points.col(triangle[0])) / 6;
  }
  EXPECT_NEAR(sum.norm(), 0, 1e-12);
  EXPECT_NEAR(volume, 2, 1e-12);
}

TEST(PartShape, PatchEdgesAreThoseOfTheOuterFaces) {
  const auto model = two_cubes();
  // Ten unit squares of four edges each, shared or not.
  EXPECT_NEAR(length(patch_edges(model, shape_of(model))), 40, 1e-12);
  EXPECT_TRUE(element_edges(model, shape_of(model)).segments.empty());
}

TEST(PartShape, ValuesAreThePatchesNumbersOrTheScaledJacobian) {
  const auto model = two_cubes();
  const Surface patches = outer_surface(model, shape_of(model));
  EXPECT_EQ(patches.values.minCoeff<Eigen::PropagateNaN>(), 0);
  EXPECT_EQ(patches.values.maxCoeff<Eigen::PropagateNaN>(), 1);
  const Surface jacobian = outer_surface(model, shape_of(model, PictureField::jacobian));
  EXPECT_NEAR(jacobian.values.minCoeff<Eigen::PropagateNaN>(), 1, 1e-12);
  EXPECT_ERROR(shape_of(model, PictureField::von_mises), ErrorCode::invalid_argument, "without results");
}

TEST(PartShape, NormalsAreSmoothAcrossPatchesAndSharpAtEdges) {
  const auto model = geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(360)}));
  const Surface surface = outer_surface(model, shape_of(model));
  for (int i = 0; i < surface.points.cols(); ++i) {
    const Eigen::Vector3d normal = surface.normals.col(i);
    if (std::abs(normal.z()) > 0.5) {
      EXPECT_NEAR(std::abs(normal.z()), 1, 1e-12);  // top and bottom are flat up to their rims
      continue;
    }
    Eigen::Vector3d radial = surface.points.col(i);
    radial.z() = 0;
    const double side = radial.norm() > 1.5 ? 1 : -1;
    // Facets of a few degrees alone would be off by half of these.
    EXPECT_GT(side * normal.dot(radial.normalized()), std::cos(0.01)) << radial.transpose();
  }
}

TEST(PartShape, AVisibleDeformationIsRoundAndWithinBounds) {
  for (const double largest : {1.0, 3e-4, 7e-9, 42.0}) {
    iga::PartSamples samples;
    samples.patches.resize(1);
    samples.patches[0].displacements = Eigen::Matrix3Xd::Zero(3, 2);
    samples.patches[0].displacements(1, 1) = -largest;
    const double factor = visible_deformation(samples, 2);
    EXPECT_LE(factor * largest, 0.2 * (1 + 1e-12));
    EXPECT_GE(factor * largest, 0.08 * (1 - 1e-12));
    const double leading = factor / std::pow(10, std::floor(std::log10(factor) + 1e-9));
    EXPECT_THAT(std::lround(leading), testing::AnyOf(1, 2, 5));
  }
  EXPECT_EQ(visible_deformation({}, 1), 1);
}

TEST(Clip, KeepsWhatLiesBelowAndClosesIt) {
  const auto model = two_cubes();
  const auto shape = shape_of(model);
  const Cut cut = {0, 1.25};
  const Surface kept = clipped(outer_surface(model, shape), cut);
  EXPECT_NEAR(area(kept), 4 * 1.25 + 1, 1e-12);
  EXPECT_LE(kept.undeformed.row(0).maxCoeff<Eigen::PropagateNaN>(), 1.25 + 1e-12);
  const Surface face = section(shape, cut);
  EXPECT_NEAR(area(face), 1, 1e-12);
  for (const auto& triangle : face.triangles) EXPECT_GE(area_vector(face, triangle).x(), 0);
  EXPECT_NEAR((face.points.row(0).array() - 1.25).abs().maxCoeff<Eigen::PropagateNaN>(), 0, 1e-12);
  EXPECT_NEAR(length(cut_outline(outer_surface(model, shape), cut)), 4, 1e-12);
}

TEST(Clip, InTheDeformedPartCutsTheUndeformedOne) {
  const auto model = two_cubes();
  iga::PartSamples samples = iga::sample_part(model, model.patches());
  for (auto& patch : samples.patches) {
    patch.displacements = Eigen::Matrix3Xd::Zero(3, patch.points.cols());
    patch.displacements.row(0) = patch.points.row(0);
  }
  const auto shape =
      part_shape(samples, {.field = PictureField::displacement, .component = {}, .deformation = 1});
  const Surface face = section(shape, {0, 0.5});
  EXPECT_NEAR((face.points.row(0).array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), 0, 1e-12);
  EXPECT_NEAR((face.values.array() - 0.5).abs().maxCoeff<Eigen::PropagateNaN>(), 0, 1e-12);
}

TEST(Clip, OutsideThePartKeepsAllOrNothing) {
  const auto model = two_cubes();
  const auto shape = shape_of(model);
  const Surface surface = outer_surface(model, shape);
  const Lines edges = patch_edges(model, shape);
  EXPECT_NEAR(area(clipped(surface, {0, 3})), 10, 1e-12);
  EXPECT_NEAR(length(clipped(edges, {0, 3})), 40, 1e-12);
  EXPECT_TRUE(section(shape, {0, 3}).triangles.empty());
  EXPECT_TRUE(clipped(surface, {0, -1}).triangles.empty());
  EXPECT_TRUE(clipped(edges, {0, -1}).segments.empty());
  EXPECT_TRUE(cut_outline(surface, {0, -1}).segments.empty());
}

TEST(Clip, ShortensEdgesAtThePlane) {
  const auto model = two_cubes();
  // Four squares around the first cube and its end face: the edges along the axis lose three quarters of a
  // unit in each of the four squares of the second cube, twice a square; its end's four edges and those of
  // the squares that end there, four more, go.
  const Lines kept = clipped(patch_edges(model, shape_of(model)), {0, 1.25});
  EXPECT_NEAR(length(kept), 40 - 8 * 0.75 - 8, 1e-12);
  EXPECT_LE(kept.undeformed.row(0).maxCoeff<Eigen::PropagateNaN>(), 1.25 + 1e-12);
}

TEST(Clip, AcrossAPipeHasTheRingAsItsFace) {
  const auto model = geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(360)}));
  const auto shape = shape_of(model);
  const Surface surface = outer_surface(model, shape);
  const double middle = (surface.points.row(2).minCoeff<Eigen::PropagateNaN>() +
                         surface.points.row(2).maxCoeff<Eigen::PropagateNaN>()) /
                        2;
  const Surface face = section(shape, {2, middle});
  const Surface below = clipped(surface, {2, middle});
  // The divergence theorem over what is kept and the face that closes it; the same from areas of the sampled
  // ring.
  double volume = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Surface* part : {&below, &face})
    for (const auto& triangle : part->triangles) {
      sum += area_vector(*part, triangle);
      volume += area_vector(*part, triangle).dot(part->points.col(triangle[0])) / 6;
    }
  EXPECT_NEAR(sum.norm(), 0, 1e-12);
  const double height = middle - surface.points.row(2).minCoeff<Eigen::PropagateNaN>();
  EXPECT_NEAR(volume, area(face) * height, 1e-12 * volume);
  EXPECT_GT(area(face), 0);
}

TEST(Joined, KeepsBothWithTheirValues) {
  const auto model = two_cubes();
  const Surface one = outer_surface(model, shape_of(model));
  const Surface both = joined(one, one);
  EXPECT_NEAR(area(both), 20, 1e-12);
  EXPECT_EQ(both.values.tail(one.values.size()), one.values);
  EXPECT_EQ(both.triangles.back()[2], one.triangles.back()[2] + one.points.cols());
  const Lines edges = patch_edges(model, shape_of(model));
  EXPECT_NEAR(length(joined(edges, edges)), 80, 1e-12);
}

}  // namespace
}  // namespace isopatch::app
