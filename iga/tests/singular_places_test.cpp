#include "iga/estimate/singular_places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/models/box.hpp"
#include "geometry/models/bracket.hpp"
#include "geometry/models/cylinder.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using testing::boundary;
using ::testing::HasSubstr;
using testing::problem;

// What is said of a place, which need not be solved for.
std::string said_of(const ElasticityProblem& p, const Eigen::Vector3d& place) {
  ElasticField field{p.discretization.patches, {}, p.materials};
  for (const geometry::NurbsVolume& patch : field.patches)
    field.displacement.emplace_back(Eigen::Matrix3Xd::Zero(3, patch.size()));
  const Location found = locate(field, place);
  return singular_places(p, {{found.patch, found.parameter}}).at(0).value_or("");
}

ElasticityProblem bracket() {
  ElasticityProblem p = problem(geometry::connect(geometry::bracket_model()), {.refine = 2}, testing::steel);
  p.supports = {{"end", boundary(p.discretization.model, "y_max"), PrescribedDisplacement{}}};
  return p;
}

TEST(SingularPlaces, AreReentrantEdges) {
  EXPECT_EQ(said_of(bracket(), {1, 1, 0.4}), "a re-entrant edge of 270 degrees");
  EXPECT_EQ(said_of(bracket(), {0, 0, 0.4}), "");    // a convex edge
  EXPECT_EQ(said_of(bracket(), {1.5, 1, 0.4}), "");  // a smooth face, where patches have edges elsewhere
  EXPECT_EQ(said_of(bracket(), {1, 0.5, 0.4}), "");  // inside, where patches meet
  EXPECT_EQ(said_of(bracket(), {1, 1, 0.4}), said_of(bracket(), {1, 0.97, 0.4}));  // near it
}

// With elements of their own, and with one side that meets two.
TEST(SingularPlaces, AreSeenAcrossFacesThatDoNotMatch) {
  DiscretizationOptions options{.refine = 1, .spread = false};
  options.patches = {{.patches = {0}, .refine = 1}};
  ElasticityProblem p = problem(geometry::connect(geometry::bracket_model()), options, testing::steel);
  ASSERT_FALSE(p.discretization.model.non_matching().empty());
  EXPECT_EQ(said_of(p, {1, 1, 0.4}), "a re-entrant edge of 270 degrees");
  EXPECT_EQ(said_of(p, {1, 0.5, 0.4}), "");
  EXPECT_EQ(said_of(p, {1, 0, 0.4}), "");
  p.materials[0] = isotropic(1e9, 0.3);
  EXPECT_EQ(said_of(p, {1, 0, 0.4}), "an edge where materials meet");
  // A box of half the length on another: its end rises from the middle of a face.
  geometry::PatchSet step = geometry::box_model({.size = {2, 1, 1}});
  const geometry::PatchSet above = geometry::box_model({.size = {1, 1, 1}, .origin = {0, 0, 1}});
  step.patches.insert(step.patches.end(), above.patches.begin(), above.patches.end());
  const ElasticityProblem t =
      problem(geometry::connect(step, {.keep_non_matching = true}), {.refine = 1}, testing::steel);
  EXPECT_EQ(said_of(t, {1, 0.4, 1.01}), "a re-entrant edge of 270 degrees");
  EXPECT_EQ(said_of(t, {0, 0.4, 1.01}), "");
}

TEST(SingularPlaces, AreWhereAClampedFaceEnds) {
  EXPECT_EQ(said_of(bracket(), {1, 2, 0.4}), "the end of a clamped face");
  ElasticityProblem rolling = bracket();
  rolling.supports[0].condition = PlaneSupport{};
  EXPECT_EQ(said_of(rolling, {1, 2, 0.4}), "");
}

TEST(SingularPlaces, AreWhereMaterialsMeetInTheOpen) {
  ElasticityProblem p = bracket();
  EXPECT_EQ(said_of(p, {1, 0, 0.4}), "");
  p.materials[0] = isotropic(1e9, 0.3);
  EXPECT_EQ(said_of(p, {1, 0, 0.4}), "an edge where materials meet");
  p.supports.push_back({"side", boundary(p.discretization.model, "y_min"), PlaneSupport{}});
  EXPECT_EQ(said_of(p, {1, 0, 0.4}), "");
}

TEST(SingularPlaces, AreRimsOfPartsAndPoints) {
  ElasticityProblem p = bracket();
  p.supports = {{"pad", boundary(p.discretization.model, "bottom"), PrescribedDisplacement{}}};
  p.supports[0].region = inside_cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.3);
  EXPECT_EQ(said_of(p, {0.8, 0.5, 0}), "the rim of a part that is held");
  EXPECT_EQ(said_of(p, {0.5, 0.5, 0}), "");    // amid it
  EXPECT_EQ(said_of(p, {0.8, 0.5, 0.5}), "");  // above it
  p.supports[0].condition = ElasticSupport{1, 1};
  EXPECT_EQ(said_of(p, {0.8, 0.5, 0}), "");
  p.point_loads = {{"finger", {1, 0, 0}, {{PatchId(0), {0.5, 0.5, 1}, 1}}}};
  const Eigen::Vector3d finger = p.discretization.patches[0].point({0.5, 0.5, 1});
  EXPECT_EQ(said_of(p, finger), "a point that is loaded");
  p.supports[0] = {"nail", {}, PrescribedDisplacement{}};
  p.supports[0].points = {{PatchId(0), {0.5, 0.5, 1}, 1}};
  EXPECT_EQ(said_of(p, finger), "a point that is held");
}

TEST(SingularPlaces, AreLinesThatAreHeld) {
  ElasticityProblem p = bracket();
  p.supports.push_back({"line", {}, PrescribedDisplacement{}, {{PatchId(0), {2, {false, false}}}}});
  EXPECT_EQ(said_of(p, {0, 0, 0.4}), "a line that is held");
}

// Of curved patches angles are those of tangents: a round wall has no edge where patches meet on it.
TEST(SingularPlaces, AreNotOnRoundWalls) {
  const ElasticityProblem p = problem(geometry::connect(geometry::cylinder_model({.patches_around = 2})),
                                      {.refine = 1}, testing::steel);
  const double half = std::sqrt(0.5);
  EXPECT_EQ(said_of(p, {half, half, 0.25}), "");
  EXPECT_EQ(said_of(p, {2 * half, 2 * half, 0.25}), "");
}

}  // namespace
}  // namespace isopatch::iga
