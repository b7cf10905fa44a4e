#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/face_match.hpp"
#include "geometry/measures.hpp"
#include "geometry/multi_patch.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

using test::box_between;
using test::closed_ring;
using test::eight_boxes;
using test::permuted;
using test::ring_sector;
using ::testing::AllOf;
using ::testing::HasSubstr;

double volume_of(const MultiPatch& model) {
  double sum = 0;
  for (const NurbsVolume& patch : model.patches()) sum += volume(patch);
  return sum;
}

// The largest distance between the two faces of an interface at random parameters.
double worst_gap(const MultiPatch& model, std::mt19937& random) {
  std::uniform_real_distribution<double> share;
  double worst = 0;
  for (const Interface& i : model.interfaces()) {
    const NurbsSurface first = face_surface(model.patch(i.first.patch), i.first.side);
    const NurbsSurface second = face_surface(model.patch(i.second.patch), i.second.side);
    for (int k = 0; k < 5; ++k) {
      const Parameter<2> at(share(random), share(random));
      const Parameter<2> back = inverse(i.orientation)(i.orientation(at));
      EXPECT_LT((back - at).norm(), 1e-15);
      worst = larger(
          worst,
          (first.point(unscaled(first, at)) - second.point(unscaled(second, i.orientation(at)))).norm());
    }
  }
  return worst;
}

std::string refusal(PatchSet set, ErrorCode code = ErrorCode::not_conforming,
                    const Tolerance& tolerance = {}) {
  try {
    connect(std::move(set), tolerance);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    return error.what();
  }
  return "accepted";
}

TEST(Connect, FindsTheSameInterfacesHoweverThePatchesAreParametrized) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any(0, 47);
  for (int trial = 0; trial < 48; ++trial) {
    PatchSet set{eight_boxes(), {}, {}};
    for (std::size_t i = 0; i < 8; ++i)
      set.patches[i] = permuted(set.patches[i], i == 0 ? trial : any(random));
    const MultiPatch model = connect(set);
    ASSERT_EQ(model.interfaces().size(), 12u);
    ASSERT_EQ(model.boundary_faces().size(), 24u);
    EXPECT_TRUE(model.degenerate_faces().empty());
    EXPECT_EQ(model.bodies().size(), 1u);
    EXPECT_NEAR(volume_of(model), 15, 1e-13);
    EXPECT_LT(worst_gap(model, random), 1e-14);
  }
}

TEST(Connect, MeetsAllEightOrientations) {
  std::mt19937 random(2);
  std::vector<FaceOrientation> met;
  for (int a = 0; a < 48; a += 7)
    for (int b = 0; b < 48; ++b) {
      // The shared face is a rectangle with different sides, so only one orientation is right.
      const MultiPatch model = connect(
          {{permuted(box_between({0, 0, 0}, {1, 2, 3}), a), permuted(box_between({1, 0, 0}, {2, 2, 3}), b)},
           {},
           {}});
      ASSERT_EQ(model.interfaces().size(), 1u);
      ASSERT_LT(worst_gap(model, random), 1e-14);
      met.push_back(model.interfaces()[0].orientation);
    }
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  EXPECT_EQ(met.size(), 8u);
}

TEST(Connect, JoinsFacesWithDifferentKnots) {
  NurbsVolume coarse = ring_sector(1, 2, 0, 1, 3);
  NurbsVolume fine = elevate_degree(insert_knots(ring_sector(2, 4, 0, 1, 3), 1, {0.1, 0.3, 0.3, 0.9}), 2, 2);
  std::mt19937 random(3);
  const MultiPatch model = connect({{coarse, permuted(fine, 19)}, {}, {}});
  ASSERT_EQ(model.interfaces().size(), 1u);
  EXPECT_LT(worst_gap(model, random), 2e-15 * model.size());
}

TEST(Connect, DoesNotJoinTheHalvesOfARingByTheirCorners) {
  // West of one half and west of the other share four corners, as do the two easts; neither is an interface.
  const MultiPatch model =
      connect({{ring_sector(1, 2, 0, std::numbers::pi, 0.5),
                permuted(ring_sector(1, 2, std::numbers::pi, 2 * std::numbers::pi, 0.5), 37)},
               {},
               {}});
  ASSERT_EQ(model.interfaces().size(), 2u);
  EXPECT_EQ(model.boundary_faces().size(), 8u);
  for (const Interface& i : model.interfaces())
    EXPECT_NEAR(area(face_surface(model.patch(i.first.patch), i.first.side)), 0.5, 1e-14);
}

TEST(Connect, LetsAPatchBeItsOwnNeighbour) {
  const MultiPatch model = connect({{closed_ring(1, 2, 0.5)}, {}, {}});
  ASSERT_EQ(model.interfaces().size(), 1u);
  const Interface& seam = model.interfaces()[0];
  EXPECT_EQ(seam.first, (PatchFace{PatchId(0), Side::south}));
  EXPECT_EQ(seam.second, (PatchFace{PatchId(0), Side::north}));
  EXPECT_EQ(seam.orientation, FaceOrientation());
  EXPECT_EQ(model.boundary_faces().size(), 4u);
}

TEST(Connect, SetsCollapsedFacesAside) {
  // A full cylinder: the inner face of the ring is its axis.
  const NurbsVolume ring = closed_ring(1, 2, 0.5);
  Eigen::Matrix3Xd points = ring.control_points();
  for (Eigen::Index i = 0; i < points.cols(); i += 2) points.col(i).head<2>().setZero();
  const MultiPatch model = connect({{NurbsVolume(ring.knots(), points, ring.weights())}, {}, {}});
  ASSERT_EQ(model.degenerate_faces().size(), 1u);
  EXPECT_EQ(model.degenerate_faces()[0], (PatchFace{PatchId(0), Side::west}));
  EXPECT_EQ(model.interfaces().size(), 1u);
  EXPECT_EQ(model.boundary_faces().size(), 3u);
  EXPECT_NEAR(volume_of(model), 2 * std::numbers::pi, 1e-12);
}

TEST(Connect, TurnsLeftHandedPatchesAroundAndTranslatesNames) {
  const PatchFace west{PatchId(1), Side::west};
  const PatchFace north{PatchId(1), Side::north};
  const NurbsVolume plain = box_between({0, 0, 0}, {1, 1, 1});
  NurbsVolume left = reversed(box_between({1, 0, 0}, {3, 1, 1}), 0);  // its west is at x = 3
  left = NurbsVolume({rescaled(left.knots(0), 2, 6), left.knots(1), left.knots(2)}, left.control_points());
  const MultiPatch model = connect(
      {{plain, left}, {{"far", {west, north}}}, {{{PatchId(0), Side::east}, {PatchId(1), Side::east}, {}}}});
  EXPECT_FALSE(model.was_reversed(PatchId(0)));
  EXPECT_TRUE(model.was_reversed(PatchId(1)));
  EXPECT_EQ(model.from_input(west), (PatchFace{PatchId(1), Side::east}));
  EXPECT_EQ(model.to_input(model.from_input(west)), west);
  EXPECT_EQ(model.from_input(PatchFace{PatchId(0), Side::west}), (PatchFace{PatchId(0), Side::west}));
  EXPECT_EQ(model.boundaries()[0].faces, (std::vector{model.from_input(west), north}));
  EXPECT_EQ(model.label(model.from_input(west)), "1:west");
  const Parameter<3> as_given(2.5, 0.2, 0.7);
  const Parameter<3> inside = model.from_input(PatchId(1), as_given);
  EXPECT_LT((model.patch(PatchId(1)).point(inside) - left.point(as_given)).norm(), 1e-15);
  EXPECT_LT((model.to_input(PatchId(1), inside) - as_given).norm(), 1e-15);
  EXPECT_GT(volume(model.patch(PatchId(1))), 0);
}

TEST(Connect, TellsTheHandednessOfAPatchWhoseMiddleIsFlat) {
  // x = (2u - 1)^3 has no derivative in the middle.
  const NurbsVolume cube =
      test::mapped({KnotVector::bezier(3), KnotVector(), KnotVector()}, [](const Eigen::Vector3d& t) {
        return Eigen::Vector3d(t[0] == 0 ? -1 : t[0] < 0.4 ? 1 : t[0] < 0.8 ? -1 : 1, t[1], t[2]);
      });
  ASSERT_LT(std::abs(cube.jacobian(Parameter<3>(0.5, 0.5, 0.5)).determinant()), 1e-15);
  EXPECT_FALSE(connect({{cube}, {}, {}}).was_reversed(PatchId(0)));
  EXPECT_TRUE(connect({{reversed(cube, 2)}, {}, {}}).was_reversed(PatchId(0)));
}

TEST(Connect, NamesFacesThatNearlyMeet) {
  // A model of size about 3.7; the gap is 1e-4 of it.
  const double gap = 4e-4;
  const NurbsVolume first = box_between({0, 0, 0}, {1, 2, 2});
  EXPECT_THAT(
      refusal({{first, reversed(box_between({1 + gap, 0, 0}, {2, 2, 2}), 0)}, {}, {}}),
      AllOf(HasSubstr("0:east and 1:east nearly meet"), HasSubstr("0.0004"), HasSubstr("model.same_point")));
  EXPECT_THAT(refusal({{first, box_between({1 - gap, 0, 0}, {2, 2, 2})}, {}, {}}),
              HasSubstr("0:east and 1:west nearly meet"));
  EXPECT_THAT(refusal({{first, box_between({1, gap, 0}, {2, 2 + gap, 2})}, {}, {}}),
              HasSubstr("0:east and 1:west nearly meet"));
}

TEST(Connect, JoinsFacesThatDifferByLessThanTheTolerance) {
  const double gap = 1e-6;
  const PatchSet set{{box_between({0, 0, 0}, {1, 2, 2}), box_between({1 + gap, 0, 0}, {2, 2, 2})}, {}, {}};
  const MultiPatch model = connect(set);
  ASSERT_EQ(model.interfaces().size(), 1u);
  EXPECT_NEAR(model.interfaces()[0].gap, gap, 1e-15);
  EXPECT_THAT(refusal(set, ErrorCode::not_conforming, {.same_point = 1e-7}), HasSubstr("nearly meet"));
}

TEST(Connect, SeesADifferenceInsideOneKnotSpan) {
  // The faces agree but for one inner control point of a fine face.
  const KnotVector fine = KnotVector::uniform(3, 20);
  const NurbsVolume first =
      test::mapped({KnotVector(), fine, fine}, [](const Eigen::Vector3d& t) { return t; });
  Eigen::Matrix3Xd points = first.control_points();
  points.row(0).array() += 1;
  points(0, 2 * (7 + 13 * fine.size())) += 1e-3;
  const NurbsVolume dented(first.knots(), points);
  EXPECT_THAT(refusal({{first, dented}, {}, {}}), HasSubstr("0:east and 1:west nearly meet"));
}

TEST(Connect, TakesThinWallsForWalls) {
  // Thickness 5e-4 of the size and 3.5e-4 of the faces' diagonal, in one layer and in three.
  const double h = 5e-4;
  const MultiPatch one = connect({{box_between({0, 0, 0}, {1, 1, h})}, {}, {}});
  EXPECT_EQ(one.boundary_faces().size(), 6u);
  PatchSet layers;
  for (int i = 0; i < 3; ++i)
    layers.patches.push_back(box_between({0, 0, i * h / 3}, {1, 1, (i + 1) * h / 3}));
  const MultiPatch three = connect(layers);
  EXPECT_EQ(three.interfaces().size(), 2u);
  EXPECT_EQ(three.boundary_faces().size(), 14u);
}

TEST(Connect, TakesTheSidesOfAWedgeForApart) {
  // Cut along its length in the middle: two patches, whose outer sides nearly meet at their thin ends.
  const double h = 1e-3;
  const auto half = [&](double sign) {
    Eigen::Matrix3Xd points(3, 8);
    points << 0, 1, 0, 1, 0, 1, 0, 1,  //
        0, 0, 1, 1, 0, 0, 1, 1,        //
        0, 0, 0, 0, h, h / 10, h, h / 10;
    points.row(2) *= sign;
    return NurbsVolume({KnotVector(), KnotVector(), KnotVector()}, points);
  };
  const MultiPatch wedge = connect({{half(1), half(-1)}, {}, {}});
  EXPECT_EQ(wedge.interfaces().size(), 1u);
  // Two sides of one patch, at its sharp corner.
  Eigen::Matrix3Xd kite(3, 8);
  kite << 0, 0.5, 0.5, 2.0 / 3, 0, 0.5, 0.5, 2.0 / 3,  //
      0, 0, h / 2, h / 3, 0, 0, h / 2, h / 3,          //
      0, 0, 0, 0, 1, 1, 1, 1;
  EXPECT_EQ(connect({{NurbsVolume({KnotVector(), KnotVector(), KnotVector()}, kite)}, {}, {}}).patch_count(),
            1);
}

TEST(Connect, SaysHowThinAPatchIsAndWhere) {
  EXPECT_THAT(refusal({{box_between({0, 0, 0}, {10, 10, 1e-5})}, {}, {}}),
              AllOf(HasSubstr("is 1e-05 thick at (5, 5, 5e-06)"), HasSubstr("1.41e-05 count as one"),
                    HasSubstr("lower same_point to 4e-08")));
  connect({{box_between({0, 0, 0}, {10, 10, 1e-5})}, {}, {}}, {.same_point = 4e-8});
}

TEST(Connect, SeesAGapBetweenThinPlates) {
  // The gap is most of the plates' thickness, but it lies outside both.
  EXPECT_THAT(
      refusal({{box_between({0, 0, 0}, {1, 1, 1e-3}), box_between({0, 0, 1.8e-3}, {1, 1, 2.8e-3})}, {}, {}}),
      HasSubstr("0:back and 1:front nearly meet"));
}

TEST(Connect, TakesSmallFacesForFaces) {
  // Two pins of width 1e-3 side by side on a model of size 17, their free sides 5e-4 apart: far for such
  // faces.
  const double w = 1e-3;
  const MultiPatch model =
      connect({{box_between({0, 0, 0}, {w, w, w}), box_between({1.5 * w, 0, 0}, {2.5 * w, w, w}),
                box_between({1, 1, 1}, {10, 10, 10})},
               {},
               {}});
  EXPECT_TRUE(model.interfaces().empty());
  EXPECT_EQ(model.bodies().size(), 3u);
}

TEST(Connect, RefusesMoreThanTwoFacesInOnePlace) {
  const NurbsVolume a = box_between({0, 0, 0}, {1, 1, 1});
  const NurbsVolume b = box_between({1, 0, 0}, {2, 1, 1});
  const NurbsVolume c = box_between({1, 0, 0}, {3, 1, 1});
  EXPECT_THAT(refusal({{a, b, c}, {}, {}}),
              AllOf(HasSubstr("more than two faces in one place"), HasSubstr("0:east"), HasSubstr("1:west"),
                    HasSubstr("2:west")));
  EXPECT_THAT(refusal({{a, permuted(a, 5)}, {}, {}}), HasSubstr("same side"));
}

TEST(Connect, RefusesFacesWithOtherParametersOrOutlines) {
  const NurbsVolume box = test::mapped({KnotVector(), KnotVector::bezier(2), KnotVector()},
                                       [](const Eigen::Vector3d& t) { return t; });
  Eigen::Matrix3Xd points = box.control_points();
  for (auto point : points.colwise()) {
    point[0] += 1;
    if (point[1] == 0.5) point[1] = 0.7;
  }
  const NurbsVolume skewed(box.knots(), points);
  EXPECT_THAT(refusal({{box, skewed}, {}, {}}),
              AllOf(HasSubstr("0:east and 1:west"), HasSubstr("parametrized differently")));
  // A T-joint: two faces on one.
  EXPECT_THAT(
      refusal({{box, box_between({1, 0, 0}, {2, 0.5, 1}), box_between({1, 0.5, 0}, {2, 1, 1})}, {}, {}}),
      AllOf(HasSubstr("0:east and 1:west"), HasSubstr("different outlines")));
}

TEST(Connect, HoldsTheListOfInterfacesAgainstTheGeometry) {
  const PatchFace a{PatchId(0), Side::east};
  const PatchFace b{PatchId(1), Side::west};
  PatchSet set{{box_between({0, 0, 0}, {1, 1, 1}), box_between({1, 0, 0}, {2, 1, 1})}, {}, {{b, a, {}}}};
  EXPECT_EQ(connect(set).interfaces().size(), 1u);
  set.interfaces = {{a, {PatchId(1), Side::east}, {}}};
  EXPECT_THAT(refusal(set), AllOf(HasSubstr("0:east - 1:east"), HasSubstr("differ by up to 1 ")));
  set.interfaces = {{a, b, {.flip_first = true}}};
  EXPECT_THAT(refusal(set), AllOf(HasSubstr("0:east - 1:west lie on each other, but not as it says"),
                                  HasSubstr("leave the interfaces out")));
}

TEST(Connect, GivesTheSameModelWhetherInterfacesAreStatedOrFound) {
  std::mt19937 random(4);
  std::uniform_int_distribution<int> any(0, 47);
  for (int trial = 0; trial < 20; ++trial) {
    PatchSet set{eight_boxes(), {}, {}};
    for (NurbsVolume& patch : set.patches) patch = permuted(patch, any(random));
    const MultiPatch found = connect(set);
    for (const Interface& i : found.interfaces())
      set.interfaces.push_back(turned_around({i.first, i.second, i.orientation},
                                             found.was_reversed(i.first.patch),
                                             found.was_reversed(i.second.patch)));
    EXPECT_EQ(connect(set).interfaces(), found.interfaces());
    // In any order, from either side, and only some of them.
    std::shuffle(set.interfaces.begin(), set.interfaces.end(), random);
    set.interfaces.resize(7);
    for (std::size_t i = 0; i < 7; i += 2) set.interfaces[i] = exchanged(set.interfaces[i]);
    EXPECT_EQ(connect(set).interfaces(), found.interfaces());
    StatedInterface& wrong = set.interfaces.front();
    wrong.orientation.flip_second = !wrong.orientation.flip_second;
    EXPECT_THAT(refusal(set), HasSubstr("not as it says"));
  }
}

TEST(Connect, RefusesWhatDoesNotExist) {
  const NurbsVolume box;
  EXPECT_THAT(refusal({}, ErrorCode::invalid_argument), HasSubstr("at least one patch"));
  EXPECT_THAT(refusal({{box}, {{"clamp", {{PatchId(1), Side::west}}}}, {}}, ErrorCode::invalid_argument),
              AllOf(HasSubstr("'clamp'"), HasSubstr("1:west")));
  EXPECT_THAT(refusal({{box}, {}, {{{PatchId(0), Side::west}, {PatchId(-1), Side::west}, {}}}},
                      ErrorCode::invalid_argument),
              HasSubstr("-1:west"));
  const NurbsVolume point(box.knots(), Eigen::Matrix3Xd::Ones(3, 8));
  EXPECT_THAT(refusal({{point}, {}, {}}, ErrorCode::invalid_argument), HasSubstr("diagonal"));
  EXPECT_THAT(refusal({{box}, {}, {}}, ErrorCode::invalid_argument, {.same_point = 0.5}),
              HasSubstr("(0, 1e-2)"));
  EXPECT_THAT(refusal({{box}, {}, {}}, ErrorCode::invalid_argument, {.same_point = 1e-3, .near_miss = 1e-3}),
              HasSubstr("near_miss is 0.001; its range is (same_point, 0.1)"));
  EXPECT_THAT(refusal({{box}, {}, {}}, ErrorCode::invalid_argument, {.same_knot = 0}),
              HasSubstr("same_knot is 0; its range is (0, 1e-3)"));
}

TEST(Connect, KeepsTheNamesOfPatches) {
  PatchSet set{{box_between({0, 0, 0}, {1, 1, 1}), box_between({5, 0, 0}, {6, 1, 1})}, {}, {}};
  set.names = {"wheel"};
  const MultiPatch model = connect(set);
  EXPECT_EQ(model.patch_name(PatchId(0)), "wheel");
  EXPECT_EQ(model.patch_name(PatchId(1)), "");
  EXPECT_EQ(box(model).max(), Eigen::Vector3d(6, 1, 1));
}

TEST(Connect, TellsBodiesApart) {
  const MultiPatch model = connect({{box_between({0, 0, 0}, {1, 1, 1}), box_between({5, 0, 0}, {6, 1, 1}),
                                     box_between({1, 0, 0}, {2, 1, 1})},
                                    {},
                                    {}});
  const std::vector<std::vector<PatchId>> expected = {{PatchId(0), PatchId(2)}, {PatchId(1)}};
  EXPECT_EQ(model.bodies(), expected);
}

TEST(Connect, FindsTheInterfacesOfManyPatchesQuickly) {
  constexpr int n = 7;
  PatchSet set;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        set.patches.push_back(box_between({1.0 * i, 1.0 * j, 1.0 * k}, {i + 1.0, j + 1.0, k + 1.0}));
  const MultiPatch model = connect(set);
  EXPECT_EQ(model.interfaces().size(), 3u * n * n * (n - 1));
  EXPECT_EQ(model.boundary_faces().size(), 6u * n * n);
}

// One box below two, of which the second leaves a part of it free.
PatchSet t_joint(double end) {
  return {{box_between({0, 0, 0}, {2, 1, 1}), box_between({0, 0, 1}, {0.7, 1, 2}),
           box_between({0.7, 0, 1}, {end, 1, 2})},
          {},
          {}};
}

TEST(Connect, RefusesTJointsUnlessAskedToKeepThem) {
  EXPECT_THAT(refusal(t_joint(2)), AllOf(HasSubstr("lie on one another"), HasSubstr("nitsche")));
  const MultiPatch model = connect(t_joint(2), {.keep_non_matching = true});
  ASSERT_EQ(model.non_matching().size(), 2u);
  EXPECT_EQ(model.non_matching()[0].first, (PatchFace{PatchId(0), Side::back}));
  EXPECT_EQ(model.non_matching()[1].second, (PatchFace{PatchId(2), Side::front}));
  EXPECT_EQ(model.interfaces().size(), 1u);
  EXPECT_EQ(model.boundary_faces().size(), 3u * 6 - 2 - 3);
  EXPECT_TRUE(model.partly_covered().empty());
  EXPECT_EQ(model.bodies().size(), 1u);
}

TEST(Connect, FacesThatAreCoveredInPartStayOfTheBoundary) {
  const MultiPatch model = connect(t_joint(1.5), {.keep_non_matching = true});
  EXPECT_EQ(model.non_matching().size(), 2u);
  EXPECT_EQ(model.partly_covered(), (std::vector{PatchFace{PatchId(0), Side::back}}));
  EXPECT_EQ(model.boundary_faces().size(), 3u * 6 - 2 - 2);
}

TEST(Connect, RefusesNonMatchingFacesOfPatchesThatOverlap) {
  PatchSet set{{box_between({0, 0, 0}, {2, 1, 1}), box_between({0.5, 0, 0.5}, {1, 1, 1})}, {}, {}};
  EXPECT_THAT(refusal(set, ErrorCode::not_conforming, {.keep_non_matching = true}), HasSubstr("overlap"));
}

}  // namespace
}  // namespace isopatch::geometry
