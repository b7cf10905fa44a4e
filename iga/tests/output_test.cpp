// What the files for ParaView are made of: nodes, and the fields at them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/elbow.hpp"
#include "geometry/splines/refine.hpp"
#include "iga/output/hexahedra_output.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::MultiPatch;
using geometry::NurbsVolume;
using geometry::Parameter;
using geometry::PatchFace;
using geometry::Side;
using testing::problem;

// A smooth displacement on given patches: coefficients from the control points.
ElasticField smooth_field(const std::vector<NurbsVolume>& patches) {
  ElasticField field{patches, {}, std::vector<Material>(patches.size(), isotropic(200, 0.3))};
  for (const NurbsVolume& patch : patches)
    field.displacement.emplace_back(1e-3 * patch.control_points().array().sin());
  return field;
}

// Two layers of boxes with curved faces in any orientation; each patch is moved by its own round-off.
MultiPatch rounded_boxes() {
  geometry::PatchSet set =
      geometry::box_model({.patches = {2, 2, 2}, .distortion = 0.2, .curvature = 0.2, .orientation_seed = 3});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> tiny(-1e-10, 1e-10);
  for (NurbsVolume& patch : set.patches) {
    Eigen::Matrix3Xd points = patch.control_points();
    for (double& x : points.reshaped()) x += tiny(random);
    patch = NurbsVolume(patch.knots(), points, patch.weights());
  }
  return geometry::connect(set);
}

std::vector<geometry::GridParameters<3>> grids(const std::vector<NurbsVolume>& patches,
                                               const MultiPatch& model) {
  std::vector<geometry::GridParameters<3>> result;
  const auto pieces = straight_pieces(model, patches, 3);
  for (std::size_t p = 0; p < patches.size(); ++p) result.push_back(grid_of(patches[p], pieces[p]));
  return result;
}

TEST(SurfacePoints, AreEqualToTheLastBitOnBothSidesOfInterfaces) {
  const MultiPatch model = rounded_boxes();
  const Discretization d = discretize(model, {.refine = 1});
  const auto parameters = grids(d.patches, model);
  const SurfacePoints surface(model, d.patches, parameters);
  ASSERT_EQ(model.interfaces().size(), 12u);
  bool differs = false;
  for (const geometry::Interface& interface : model.interfaces()) {
    const Eigen::Matrix3Xd first = surface.face(interface.first.patch.value, interface.first.side);
    const Eigen::Matrix3Xd second = surface.face(interface.second.patch.value, interface.second.side);
    ASSERT_EQ(first.cols(), second.cols());
    const auto count = [&](const PatchFace& face, std::size_t t) {
      return static_cast<Eigen::Index>(parameters[static_cast<std::size_t>(face.patch.value)]
                                                 [static_cast<std::size_t>(tangents(face.side)[t])]
                                                     .size());
    };
    const Eigen::Index m = count(interface.first, 0), n = count(interface.first, 1);
    const Eigen::Index rows = count(interface.second, 0), columns = count(interface.second, 1);
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = 0; i < m; ++i) {
        const Parameter<2> there =
            interface.orientation({static_cast<double>(i) / static_cast<double>(m - 1),
                                   static_cast<double>(j) / static_cast<double>(n - 1)});
        const Eigen::Index at = std::lround(there[0] * static_cast<double>(rows - 1)) +
                                rows * std::lround(there[1] * static_cast<double>(columns - 1));
        EXPECT_EQ(first.col(i + m * j), second.col(at));
      }
    // The patches themselves do not agree so well.
    const auto corner = [&](const PatchFace& face) {
      return Eigen::Vector3d(face_surface(d.patches[static_cast<std::size_t>(face.patch.value)], face.side)
                                 .control_points()
                                 .col(0));
    };
    differs =
        differs ||
        (second.colwise() - corner(interface.first)).colwise().norm().minCoeff<Eigen::PropagateNaN>() > 0;
  }
  EXPECT_TRUE(differs);
}

TEST(SurfacePoints, LieOnThePatchUpToRoundOff) {
  const MultiPatch model = rounded_boxes();
  const Discretization d = discretize(model, {});
  const auto parameters = grids(d.patches, model);
  const SurfacePoints surface(model, d.patches, parameters);
  for (int p = 0; p < 8; ++p)
    for (const Side side : geometry::all_sides) {
      const auto t = geometry::tangents(side);
      const auto& all = parameters[static_cast<std::size_t>(p)];
      const Eigen::Matrix3Xd exact = geometry::points_on_grid(
          face_surface(d.patches[static_cast<std::size_t>(p)], side),
          {all[static_cast<std::size_t>(t[0])], all[static_cast<std::size_t>(t[1])]});
      EXPECT_LT((surface.face(p, side) - exact).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 1e-9);
    }
}

// A wedge: the west face is the line x = y = 0, and so is its front corner in the second model.
NurbsVolume wedge(bool to_a_point) {
  const NurbsVolume cube;
  Eigen::Matrix3Xd points = cube.control_points();
  for (int i = 0; i < 8; ++i)
    if (points(0, i) == 0) {
      points(1, i) = 1e-9 * i;
      if (to_a_point) points(2, i) = 0.5;
    }
  return NurbsVolume(cube.knots(), points);
}

TEST(SurfacePoints, OfACollapsedFaceAreACurveOrAPoint) {
  for (const bool to_a_point : {false, true}) {
    const MultiPatch model = geometry::connect({{wedge(to_a_point)}, {}, {}});
    const auto parameters = grids(model.patches(), model);
    const SurfacePoints surface(model, model.patches(), parameters);
    const Eigen::Matrix3Xd west = surface.face(0, Side::west), south = surface.face(0, Side::south),
                           north = surface.face(0, Side::north);
    const Eigen::Index n = 4;
    ASSERT_EQ(west.cols(), n * n);
    for (Eigen::Index k = 0; k < n; ++k) {
      for (Eigen::Index j = 0; j < n; ++j) EXPECT_EQ(west.col(j + n * k), west.col(to_a_point ? 0 : n * k));
      EXPECT_EQ(west.col(n * k), south.col(n * k));
      EXPECT_EQ(west.col(n * k), north.col(n * k));
    }
  }
}

TEST(StraightPieces, FollowTheTurnOfLinesAndAreSharedAcrossInterfaces) {
  const MultiPatch pipe =
      geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(180), .radial_patches = 2}));
  const auto pieces = straight_pieces(pipe, pipe.patches(), 4);
  // A quarter arc has ten pieces of nine degrees, straight lines have four.
  std::vector<int> counts = {pieces[0][0][0], pieces[0][1][0], pieces[0][2][0]};
  EXPECT_THAT(counts, ::testing::UnorderedElementsAre(4, 4, 10));
  for (const geometry::Interface& interface : pipe.interfaces()) {
    std::array<std::vector<int>, 2> ends;
    for (std::size_t side = 0; side < 2; ++side)
      for (const int t : tangents((side == 0 ? interface.first : interface.second).side))
        ends[side].push_back(pieces[static_cast<std::size_t>(
            (side == 0 ? interface.first : interface.second).patch.value)][static_cast<std::size_t>(t)][0]);
    EXPECT_THAT(ends[0], ::testing::UnorderedElementsAreArray(ends[1]));
  }
  EXPECT_ERROR(straight_pieces(pipe, pipe.patches(), 0), ErrorCode::invalid_argument, "least is 0");
  EXPECT_ERROR(straight_pieces(pipe, pipe.patches(), 33), ErrorCode::invalid_argument, "least is 33");
}

TEST(PlaneFields, AreThoseOfEvaluate) {
  const Discretization d =
      discretize(geometry::connect(geometry::elbow_model({})), {.degree = {2, 2, 2}, .refine = 1});
  const ElasticField field = smooth_field(d.patches);
  const int patch = 5;
  const NurbsVolume& volume = field.patches[patch];
  const geometry::GridParameters<3> parameters = grid_of(volume, {{{2, 1}, {3, 3}, {1, 2}}});
  PlaneFields planes(field, patch, parameters);
  ASSERT_EQ(planes.sizes(), (std::array{4, 7, 4}));
  for (int k = 0; k < 4; ++k) {
    const FieldPlane& plane = planes.plane(k);
    for (int i = 0; i < 28; ++i) {
      const FieldValues exact = evaluate(
          field, patch,
          {parameters[0][static_cast<std::size_t>(i % 4)], parameters[1][static_cast<std::size_t>(i / 4)],
           parameters[2][static_cast<std::size_t>(k)]});
      EXPECT_LT((plane.points.col(i) - exact.place).norm(), 1e-13 * exact.place.norm());
      EXPECT_LT((plane.displacement.col(i) - exact.displacement).norm(), 1e-12 * 1e-3);
      EXPECT_NEAR(plane.stress(5, i), exact.stress(0, 2), 1e-11 * exact.von_mises);
      EXPECT_NEAR(plane.strain(3, i), exact.strain(0, 1), 1e-11 * exact.strain.norm());
      EXPECT_NEAR(plane.von_mises[i] / exact.von_mises, 1, 1e-11);
    }
    EXPECT_EQ(plane.borrowed.count, 0);
    EXPECT_EQ(plane.borrowed.of, 28);
  }
}

TEST(PlaneFields, AreTheMeanWhereDerivativesJump) {
  // u = |x - 1/2| along x on two elements of degree 1: strain -1 before the middle, 1 behind it.
  const NurbsVolume cube = geometry::insert_knots(NurbsVolume(), 0, {0.5});
  Eigen::Matrix3Xd u = Eigen::Matrix3Xd::Zero(3, cube.size());
  u.row(0) = (cube.control_points().row(0).array() - 0.5).abs();
  const ElasticField field{{cube}, {u}, {isotropic(1, 0)}};
  PlaneFields planes(field, 0, {{{0, 0.25, 0.5, 0.75, 1}, {0, 1}, {0, 1}}});
  const FieldPlane& plane = planes.plane(1);
  const double expected[] = {-1, -1, 0, 1, 1};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(plane.strain(0, i), expected[i], 1e-14);
}

TEST(PlaneFields, LeaveOutTheStressOfAFold) {
  // The cube's corner (1, 1, 1) is pushed through the cube, so the map is folded about it.
  const NurbsVolume cube = elevate_degree(elevate_degree(NurbsVolume(), 0, 1), 1, 1);
  Eigen::Matrix3Xd points = cube.control_points();
  points.col(cube.size() - 1) << 0.6, 0.6, 1;
  const NurbsVolume folded(cube.knots(), points);
  ASSERT_LT(folded.jacobian({1, 1, 1}).determinant(), 0);
  ElasticField field{{folded}, {Eigen::Matrix3Xd(1e-3 * points.array().square())}, {isotropic(1, 0.3)}};
  std::vector<double> line;
  for (int i = 0; i <= 40; ++i) line.push_back(i / 40.0);
  PlaneFields planes(field, 0, {{line, line, {0, 1}}});
  const FieldPlane& plane = planes.plane(1);
  EXPECT_GT(plane.borrowed.count, 4);
  EXPECT_LT(plane.borrowed.count, 800);
  EXPECT_EQ(plane.borrowed.of, 41 * 41);
  EXPECT_LT(plane.borrowed.scaled_jacobian, 0);
  EXPECT_EQ(plane.borrowed.patch, 0);
  double largest = 0;
  for (int i = 0; i < 41 * 41; ++i)
    largest = isopatch::larger(
        largest, evaluate(field, 0,
                          {line[static_cast<std::size_t>(i % 41)], line[static_cast<std::size_t>(i / 41)], 1})
                     .von_mises);
  // Evaluated in the fold itself stress has no limit.
  EXPECT_LT(10 * plane.von_mises.maxCoeff<Eigen::PropagateNaN>(), largest);
  EXPECT_TRUE(plane.von_mises.allFinite());
}

TEST(PlaneFields, OfACollapsedEdgeAreThoseBesideIt) {
  const NurbsVolume patch = wedge(false);
  const Eigen::Matrix3Xd u = Eigen::Vector3d(1e-3, 0, 0).asDiagonal() * patch.control_points();
  const ElasticField field{{patch}, {u}, {isotropic(1000, 0)}};
  PlaneFields planes(field, 0, {{{0, 0.5, 1}, {0, 1}, {0, 1}}});
  const FieldPlane& plane = planes.plane(0);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(plane.stress(0, i), 1, 1e-6);
  EXPECT_EQ(plane.borrowed.count, 0) << "an edge that is one point is no fold";
}

TEST(HexahedraOutput, DoesNotDependOnTheNumberOfFilesOrTheirOrder) {
  const MultiPatch model = rounded_boxes();
  const Discretization d = discretize(model, {});
  const ElasticField field = smooth_field(d.patches);
  const HexahedraOutput output(field, model, 2);
  const auto size = [&](const std::vector<int>& patches) {
    std::uint64_t end = 0;
    const BorrowedStress borrowed = output.write(patches, [&](std::uint64_t place, std::string_view bytes) {
      end = std::max<std::uint64_t>(end, place + bytes.size());
    });
    return std::pair(end, borrowed.of);
  };
  EXPECT_EQ(size({0, 1, 2, 3, 4, 5, 6, 7}).second, 8 * size({3}).second);
  EXPECT_LT(size({0, 1, 2, 3, 4, 5, 6, 7}).first, 8 * size({3}).first);
}

TEST(HexahedraOutput, NumbersMaterials) {
  ElasticField field = smooth_field({NurbsVolume(), NurbsVolume(), NurbsVolume()});
  EXPECT_EQ(material_numbers(field), (std::vector{0, 0, 0}));
  field.materials[1].name = "plastic";
  EXPECT_EQ(material_numbers(field), (std::vector{0, 1, 0}));
  field.materials[2].mu *= 2;
  EXPECT_EQ(material_numbers(field), (std::vector{0, 1, 2}));
}

}  // namespace
}  // namespace isopatch::iga
