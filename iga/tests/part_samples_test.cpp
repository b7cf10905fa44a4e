#include "iga/output/part_samples.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/elbow.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;
using geometry::Parameter;

// The displacement of a twist, as coefficients in the patches' own spaces: any smooth field will do.
ElasticField twisted(const Discretization& d) {
  ElasticField field{d.patches, {}, std::vector<Material>(d.patches.size(), isotropic(200, 0.3, 1, "steel"))};
  for (const NurbsVolume& patch : d.patches) {
    const Eigen::Matrix3Xd& x = patch.control_points();
    field.displacement.emplace_back(3, x.cols());
    field.displacement.back().row(0) = -0.01 * x.row(1).cwiseProduct(x.row(2));
    field.displacement.back().row(1) = 0.01 * x.row(0).cwiseProduct(x.row(2));
    field.displacement.back().row(2) = 0.001 * x.row(0).cwiseProduct(x.row(0));
  }
  return field;
}

Discretization elbow() {
  return discretize(geometry::connect(geometry::elbow_model({})), {.degree = {2, 2, 2}, .refine = 1});
}

// Distorted, curved patches in all orientations.
Discretization box() {
  return discretize(geometry::connect(geometry::box_model(
                        {.patches = {2, 2, 2}, .distortion = 0.3, .curvature = 0.2, .orientation_seed = 7})),
                    {.refine = 1});
}

Parameter<3> parameter(const PatchSamples& s, int at) {
  const auto n = s.sizes();
  return {s.parameters[0][static_cast<std::size_t>(at % n[0])],
          s.parameters[1][static_cast<std::size_t>(at / n[0] % n[1])],
          s.parameters[2][static_cast<std::size_t>(at / n[0] / n[1])]};
}

// Numbers of the samples on a side.
std::vector<int> on_side(const PatchSamples& s, geometry::Side side) {
  return geometry::face_control_points(s.sizes(), side);
}

TEST(PartSamples, AreTheFieldsValues) {
  const Discretization d = elbow();
  ElasticField field = twisted(d);
  field.thermal.assign(d.patches.size(), {2e-3, {1e-3, 0, 3e-3}});
  const PartSamples samples = sample_part(d.model, field);
  ASSERT_EQ(samples.patches.size(), d.patches.size());
  for (int p = 0; p < d.patch_count(); ++p) {
    const PatchSamples& s = samples.patches[static_cast<std::size_t>(p)];
    for (int at = 0; at < s.points.cols(); at += 7) {
      const FieldValues v = evaluate(field, p, parameter(s, at));
      const Eigen::Matrix3d jacobian = d.patches[static_cast<std::size_t>(p)].jacobian(parameter(s, at));
      EXPECT_LT((s.points.col(at) - v.place).norm(), 1e-12);
      EXPECT_LT((s.displacements.col(at) - v.displacement).norm(), 1e-13);
      EXPECT_NEAR(s.von_mises[at], v.von_mises, 1e-9 * v.von_mises);
      Eigen::Matrix<double, 6, 1> stress;
      stress << v.stress.diagonal(), v.stress(0, 1), v.stress(1, 2), v.stress(2, 0);
      EXPECT_LT((s.stress.col(at) - stress).norm(), 1e-9 * stress.norm());
      EXPECT_NEAR(s.principal.col(at).sum(), v.stress.trace(), 1e-9 * stress.norm());
      EXPECT_NEAR(s.scaled_jacobian[at], jacobian.determinant() / jacobian.colwise().norm().prod(), 1e-12);
    }
  }
}

TEST(PartSamples, OfACollapsedEdgeHaveTheStressBesideIt) {
  const NurbsVolume cube;
  Eigen::Matrix3Xd points = cube.control_points();
  for (int i = 0; i < 8; ++i)
    if (points(0, i) == 0) points(1, i) = 0;  // a wedge whose edge is the z axis
  const geometry::MultiPatch model = geometry::connect({{NurbsVolume(cube.knots(), points)}, {}, {}});
  const Discretization d = discretize(model);
  const ElasticField field = twisted(d);
  const PatchSamples s = sample_part(d.model, field).patches[0];
  EXPECT_EQ(s.scaled_jacobian.minCoeff<Eigen::PropagateNaN>(), 0);
  EXPECT_TRUE(s.von_mises.allFinite());
  EXPECT_LT(s.von_mises.maxCoeff<Eigen::PropagateNaN>(), 100);
}

TEST(PartSamples, OfNeighboursCoincide) {
  for (const Discretization& d : {elbow(), box()}) {
    const PartSamples samples = sample_part(d.model, twisted(d));
    for (const geometry::Interface& interface : d.model.interfaces()) {
      const PatchSamples& first = samples.patches[static_cast<std::size_t>(interface.first.patch.value)];
      const PatchSamples& second = samples.patches[static_cast<std::size_t>(interface.second.patch.value)];
      const std::vector<int> others = on_side(second, interface.second.side);
      const std::vector<int> own = on_side(first, interface.first.side);
      ASSERT_EQ(own.size(), others.size());
      for (const int at : own) {
        double nearest = 1e300;
        for (const int other : others)
          nearest = isopatch::smaller(nearest, (first.points.col(at) - second.points.col(other)).norm());
        EXPECT_LT(nearest, 1e-12);
      }
    }
  }
}

TEST(PartSamples, StayWithinTheChord) {
  const Discretization d = elbow();
  const double size = d.model.size();
  for (const double chord : {1e-2, 1e-3, 1e-4}) {
    const PartSamples samples = sample_part(d.model, d.patches, {.chord = chord, .most_per_element = 64});
    ASSERT_FALSE(samples.is_coarse);
    double worst = 0;
    for (std::size_t p = 0; p < d.patches.size(); ++p) {
      const PatchSamples& s = samples.patches[p];
      for (int at = 0; at + 1 < s.points.cols(); ++at) {  // along the curved second direction
        const auto n = s.sizes();
        if (at / n[0] % n[1] == n[1] - 1) continue;
        const Parameter<3> middle = 0.5 * (parameter(s, at) + parameter(s, at + n[0]));
        const Eigen::Vector3d chord_middle = 0.5 * (s.points.col(at) + s.points.col(at + n[0]));
        worst = isopatch::larger(worst, (d.patches[p].point(middle) - chord_middle).norm() / size);
      }
    }
    EXPECT_LE(worst, chord);
    EXPECT_GT(worst, 0.1 * chord) << "far more samples than asked for";
  }
}

TEST(PartSamples, FollowTheFieldWhereTheGeometryIsStraight) {
  const Discretization d = discretize(geometry::connect(geometry::box_model({})), {.degree = {3, 3, 3}});
  ElasticField field = twisted(d);
  EXPECT_EQ(sample_part(d.model, d.patches).patches[0].points.cols(), 8);
  EXPECT_GT(sample_part(d.model, field).patches[0].points.cols(), 8);
  // A cubic that is 0 at both ends and the middle of an edge still is no line.
  field.displacement[0].setZero();
  field.displacement[0](0, 1) = 1;
  field.displacement[0](0, 2) = -1;
  EXPECT_GT(sample_part(d.model, field).patches[0].sizes()[0], 3);
}

TEST(PartSamples, KeepToTheMostPoints) {
  const Discretization d = box();  // 64 elements
  for (const std::int64_t most : {20'000, 1'000, 400, 100}) {
    const PartSamples samples = sample_part(d.model, twisted(d), {.field = 1e-6, .most_points = most});
    Eigen::Index total = 0;
    for (const PatchSamples& s : samples.patches) {
      total += s.points.cols();
      for (std::size_t e = 0; e < 3; ++e) EXPECT_EQ(s.element_ends[e].back(), s.sizes()[e] - 1);
    }
    EXPECT_TRUE(samples.is_coarse);
    EXPECT_LE(total, most);
    EXPECT_GE(total, most / 10);
  }
}

TEST(PartSamples, RefuseOptionsOutOfRange) {
  const Discretization d = box();
  EXPECT_ERROR(sample_part(d.model, d.patches, {.chord = 0}), ErrorCode::invalid_argument, "chord is 0");
  EXPECT_ERROR(sample_part(d.model, d.patches, {.field = -1}), ErrorCode::invalid_argument, "field is -1");
  EXPECT_ERROR(sample_part(d.model, d.patches, {.most_per_element = 65}), ErrorCode::invalid_argument,
               "most_per_element is 65");
  EXPECT_ERROR(sample_part(d.model, d.patches, {.most_points = 7}), ErrorCode::invalid_argument,
               "most_points is 7");
}

}  // namespace
}  // namespace isopatch::iga
