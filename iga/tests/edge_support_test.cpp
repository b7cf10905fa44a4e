// Supports that hold lines.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/error.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::PatchEdge;
using testing::boundary;

// The edges of all patches that lie on a line parallel to x, found by their ends.
std::vector<SupportedEdge> edges_along_x(const geometry::MultiPatch& model, double y, double z) {
  std::vector<SupportedEdge> result;
  for (int p = 0; p < model.patch_count(); ++p)
    for (const PatchEdge& edge : geometry::all_edges()) {
      const geometry::NurbsVolume& patch = model.patch(PatchId(p));
      const std::vector<int> points = geometry::edge_control_points(patch.sizes(), edge);
      const auto on_line = [&](int i) {
        return (patch.control_points().col(i).tail<2>() - Eigen::Vector2d(y, z)).norm() < 1e-12;
      };
      if (on_line(points.front()) && on_line(points.back())) result.push_back({PatchId(p), edge});
    }
  return result;
}

// A box pulled along x, free to contract: held in its plane x = 0, on the line y = z = 0 and, against turning
// about it, on the line y = 0, z = 1.
ElasticityProblem pulled_box() {
  const geometry::MultiPatch model = geometry::connect(
      geometry::box_model({.patches = {2, 2, 2}, .distortion = 0.2, .seed = 7, .orientation_seed = 3}));
  ElasticityProblem p = testing::problem(model, {.degree = {2, 2, 2}}, isotropic(10, 0.25));
  PrescribedDisplacement line{.value = {std::nullopt, 0.0, 0.0}};
  PrescribedDisplacement across{.value = {std::nullopt, 0.0, std::nullopt}};
  p.supports = {{"plane", boundary(model, "x_min"), PlaneSupport{}},
                {"line", {}, line, edges_along_x(model, 0, 0)},
                {"second line", {}, across, edges_along_x(model, 0, 1)}};
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1, 0, 0})};
  return p;
}

TEST(EdgeSupport, LeavesAPulledBoxItsUniformStressInBothCouplings) {
  const ElasticityProblem problem = pulled_box();
  ASSERT_EQ(problem.supports[1].edges.size(), 2u);
  const Eigen::Matrix3d uniform = Eigen::Vector3d(1, 0, 0).asDiagonal();
  for (const Coupling coupling : {Coupling::elimination, Coupling::lagrange}) {
    const ElasticitySolution s = solve_elasticity(problem, {.coupling = coupling});
    EXPECT_NEAR(s.results.internal_energy, 0.5 * 0.1, 1e-13);
    for (int p = 0; p < problem.discretization.patch_count(); ++p) {
      const FieldValues values = evaluate(s.field, p, {0.3, 0.6, 0.2});
      EXPECT_LE((values.stress - uniform).norm(), 1e-12);
      EXPECT_LE(
          (values.displacement - 0.1 * Eigen::Vector3d(1, -0.25, -0.25).cwiseProduct(values.place)).norm(),
          1e-13);
    }
    for (const std::size_t line : {std::size_t{1}, std::size_t{2}})
      EXPECT_LE(s.results.reactions[line].force.norm(), 1e-12);
  }
}

TEST(EdgeSupport, HoldsOnlyItsLine) {
  // A cube pressed from above and held on two of its lower edges sags between them.
  const geometry::MultiPatch model = geometry::connect(geometry::box_model({}));
  ElasticityProblem p = testing::problem(model, {.degree = {2, 2, 2}, .elements_per_direction = {2, 4, 2}},
                                         isotropic(10, 0.25));
  std::vector<SupportedEdge> edges = edges_along_x(model, 0, 0);
  for (const SupportedEdge& edge : edges_along_x(model, 1, 0)) edges.push_back(edge);
  p.supports = {{"lines", {}, PrescribedDisplacement{}, edges}};
  p.surface_loads = {constant_traction("weight", boundary(model, "z_max"), {0, 0, -1})};
  const ElasticitySolution s = solve_elasticity(p);
  EXPECT_NEAR(s.results.reactions[0].force[2], 1, 1e-11);
  EXPECT_LE(evaluate(s.field, 0, {0.7, 0, 0}).displacement.norm(), 1e-15);
  EXPECT_LE(evaluate(s.field, 0, {0.7, 0.5, 0}).displacement[2], -0.01);
}

TEST(EdgeSupport, RefusesAPlaneAndAPatchThatIsNotThere) {
  const auto refusal = [](const Support& support) -> std::string {
    ElasticityProblem p = pulled_box();
    p.supports.push_back(support);
    try {
      solve_elasticity(p);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal({"guide", {}, PlaneSupport{}, {{PatchId(0), {}}}}),
              ::testing::HasSubstr("an edge or a point has no normal"));
  EXPECT_THAT(refusal({"hold", {}, PrescribedDisplacement{}, {{PatchId(8), {}}}}),
              ::testing::HasSubstr("'hold': there is no patch 8"));
}

}  // namespace
}  // namespace isopatch::iga
