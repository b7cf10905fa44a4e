// What cannot be solved is refused with the name of the support or load and the cause.

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "iga/problem/hydrostatic_load.hpp"
#include "iga/problem/remote_load.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using testing::boundary;

ElasticityProblem cube() {
  const auto model = geometry::connect(geometry::box_model({}));
  ElasticityProblem p = testing::problem(model, {.degree = {2, 2, 2}}, testing::steel);
  p.supports = {{"bed", boundary(model, "z_min"), PrescribedDisplacement{}}};
  return p;
}

const Region far_away = half_space({9, 0, 0}, {1, 0, 0});

TEST(HeldPoints, AreHeldWhereTheyAre) {
  ElasticityProblem p = cube();
  p.supports.push_back({.name = "pin", .condition = PlaneSupport{}, .points = {{PatchId(0)}}});
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument,
               "an edge or a point has no normal; give displacement components instead");
  p.supports.back().condition = PrescribedDisplacement{{1e-3, std::nullopt, std::nullopt}};
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument,
               "'pin': points inside of patches can be held");
}

TEST(HeldRegion, NeedsAnArea) {
  ElasticityProblem p = cube();
  p.supports.push_back({.name = "springs",
                        .faces = boundary(p.discretization.model, "z_max"),
                        .condition = ElasticSupport{1, 1},
                        .region = far_away});
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument,
               "'springs': no area of its faces lies in the region that it holds");
}

TEST(RefusedLoads, NeedWhatTheyActOn) {
  const ElasticityProblem p = cube();
  const auto top = boundary(p.discretization.model, "z_max");
  EXPECT_ERROR(hydrostatic_load("water", top, {1000, {0, 0, 5}, {0, 0, 0}}, p.discretization),
               ErrorCode::invalid_argument, "'water': a liquid needs a gravity that is not 0");
  EXPECT_ERROR(remote_load("arm", top, {.force = {1, 0, 0}}, p.discretization, far_away),
               ErrorCode::invalid_argument, "'arm': a remote force needs faces with an area to act on");
}

TEST(RefusedLoads, NeedTheirPatch) {
  ElasticityProblem p = cube();
  p.volume_loads = {
      {"weight", {PatchId(3)}, [](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, -1); }}};
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument,
               "'weight': there is no patch 3; the model has 1");
}

TEST(Temperature, NeedsItsPatch) {
  ElasticityProblem p = cube();
  p.temperatures = {{"sun", {PatchId(3)}, {20}}};
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument,
               "'sun': there is no patch 3; the model has 1");
}

TEST(ElasticityOptions, NameTheRangeOfPoints) {
  EXPECT_ERROR(solve_elasticity(cube(), {.quadrature_points = 21}), ErrorCode::invalid_argument,
               "quadrature_points is 21; its range is 0 .. 20");
}

}  // namespace
}  // namespace isopatch::iga
