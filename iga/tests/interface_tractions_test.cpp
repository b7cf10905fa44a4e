#include "iga/output/interface_tractions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/models/link.hpp"
#include "geometry/models/reorient.hpp"
#include "geometry/quadrature.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::Interface;
using geometry::Parameter;
using geometry::PatchFace;
using testing::boundary;
using testing::problem;
using testing::steel;

const Material soft = isotropic(3e9, 0.3, 1200, "soft");
// A point of an interface as its first patch sees it.
struct InterfacePoint {
  Eigen::Vector3d place;
  Eigen::Vector3d normal;  // outwards
  double measure = 0;      // quadrature weight times area
  Eigen::Vector3d traction;
  Parameter<2> scaled;  // on the first face, in [0, 1]
};

// Gauss points of an interface's elements.
std::vector<InterfacePoint> points_of(const Discretization& d, const InterfaceTraction& traction) {
  const PatchFace face = d.model.interfaces()[static_cast<std::size_t>(traction.interface)].first;
  const auto surface =
      geometry::face_surface(d.patches[static_cast<std::size_t>(face.patch.value)], face.side);
  const double outward =
      (geometry::is_high(face.side) ? 1 : -1) * (geometry::direction(face.side) == 1 ? -1 : 1);
  const geometry::QuadratureRule rule = geometry::gauss_legendre(4);
  const std::vector<double> us = surface.knots(0).breaks();
  const std::vector<double> vs = surface.knots(1).breaks();
  std::vector<InterfacePoint> points;
  for (std::size_t e = 0; e + 1 < us.size(); ++e)
    for (std::size_t f = 0; f + 1 < vs.size(); ++f)
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          const Parameter<2> at(us[e] + (us[e + 1] - us[e]) * rule.nodes[i],
                                vs[f] + (vs[f + 1] - vs[f]) * rule.nodes[j]);
          const auto tangents = surface.jacobian(at);
          const Eigen::Vector3d area =
              outward * Eigen::Vector3d(tangents.col(0)).cross(Eigen::Vector3d(tangents.col(1)));
          points.push_back(
              {surface.point(at), area.normalized(),
               rule.weights[i] * rule.weights[j] * (us[e + 1] - us[e]) * (vs[f + 1] - vs[f]) * area.norm(),
               traction_at(d, traction, face, at),
               (at - surface.low()).cwiseQuotient(surface.high() - surface.low())});
        }
  return points;
}

// A box of patches, its edges turned by an affine map, in random orientations.
geometry::MultiPatch slanted_box(const std::array<int, 3>& patches, unsigned seed) {
  Eigen::Matrix3d map;
  map << 1, 0.3, -0.2, 0, 1.1, 0.25, 0, 0, 0.9;
  geometry::PatchSet set = geometry::box_model({.patches = patches, .orientation_seed = seed});
  for (auto& patch : set.patches)
    patch = geometry::NurbsVolume(patch.knots(), map * patch.control_points(), patch.weights());
  return geometry::connect(set);
}

TEST(InterfaceTractions, AreStressTimesNormalOfAConstantStress) {
  Eigen::Matrix3d gradient;
  gradient << 1e-3, 2e-4, -3e-4, 5e-4, -7e-4, 1e-4, 2e-4, 6e-4, 4e-4;
  const Eigen::Matrix3d sigma = stress(0.5 * (gradient + gradient.transpose()), steel);
  for (const auto& patches : {std::array{2, 1, 1}, std::array{1, 3, 2}, std::array{2, 2, 2}}) {
    for (const Coupling coupling : all_couplings) {
      ElasticityProblem p = problem(slanted_box(patches, 5), {.degree = {2, 3, 2}, .refine = 1}, steel);
      p.supports = {{"boundary", p.discretization.model.boundary_faces(),
                     PrescribedDisplacement{.gradient = gradient}}};
      const ElasticitySolution solution = solve_elasticity(p, {.coupling = coupling});
      const auto tractions = interface_tractions(p, solution.multipliers);
      ASSERT_EQ(tractions.size(), p.discretization.model.interfaces().size());
      for (const InterfaceTraction& traction : tractions) {
        ASSERT_TRUE(traction.field);
        for (const InterfacePoint& point : points_of(p.discretization, traction))
          ASSERT_LT((point.traction - sigma * point.normal).norm(), 1e-9 * sigma.norm())
              << name(coupling) << ", interface " << traction.interface;
      }
    }
  }
}

TEST(InterfaceTractions, AreUniformInABarOfTwoMaterials) {
  for (const Coupling coupling : all_couplings) {
    ElasticityProblem p = problem(geometry::connect(geometry::box_model(
                                      {.size = {4, 1, 1}, .patches = {2, 2, 1}, .orientation_seed = 3})),
                                  {.degree = {2, 2, 2}, .refine = 1}, steel);
    // The soft half: Poisson's ratio 0 in both, so that the stress is uniaxial.
    const auto material = [](double young) { return isotropic(young, 0, 0, "bar"); };
    for (int i = 0; i < 4; ++i) p.materials[static_cast<std::size_t>(i)] = material(i % 2 == 0 ? 210e9 : 3e9);
    const auto& model = p.discretization.model;
    for (const char* plane : {"x_min", "y_min", "z_min"})
      p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
    p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1e6, 0, 0})};
    const ElasticitySolution solution = solve_elasticity(p, {.coupling = coupling});
    for (const InterfaceTraction& traction : interface_tractions(p, solution.multipliers))
      for (const InterfacePoint& point : points_of(p.discretization, traction))
        ASSERT_LT((point.traction - Eigen::Vector3d(1e6 * point.normal[0], 0, 0)).norm(), 1e-9 * 1e6)
            << name(coupling) << ", interface " << traction.interface;
  }
}

TEST(InterfaceTractions, AreTheSamePlaceByPlaceFromBothSides) {
  ElasticityProblem p = problem(geometry::connect(geometry::box_model(
                                    {.patches = {2, 2, 2}, .distortion = 0.3, .orientation_seed = 7})),
                                {.degree = {2, 2, 2}, .refine = 1}, steel);
  const Discretization& d = p.discretization;
  p.supports = {{"x_min", boundary(d.model, "x_min"), PrescribedDisplacement{}}};
  p.surface_loads = {constant_traction("shear", boundary(d.model, "x_max"), {0, 1e6, 2e6})};
  const ElasticitySolution solution = solve_elasticity(p);
  for (const InterfaceTraction& traction : interface_tractions(p, solution.multipliers)) {
    const Interface& interface = d.model.interfaces()[static_cast<std::size_t>(traction.interface)];
    for (const Parameter<2>& at : {Parameter<2>(0.2, 0.7), Parameter<2>(1, 0), Parameter<2>(0.6, 0.1)}) {
      const Eigen::Vector3d first = traction_at(d, traction, interface.first, at);
      const Eigen::Vector3d second = traction_at(d, traction, interface.second, interface.orientation(at));
      EXPECT_LT((first - second).norm(), 1e-12 * first.norm());
    }
  }
}

// A bar along x, clamped at x = 0, with a force at its free end.
ElasticityProblem cantilever(const std::array<int, 3>& patches, int refine) {
  ElasticityProblem p = problem(geometry::connect(geometry::box_model({.size = {4, 1, 1},
                                                                       .patches = patches,
                                                                       .distortion = 0.2,
                                                                       .curvature = 0.2,
                                                                       .distort_faces = false,
                                                                       .orientation_seed = 4})),
                                {.degree = {2, 2, 2}, .refine = refine}, steel);
  const auto& model = p.discretization.model;
  p.supports = {{"clamp", boundary(model, "x_min"), PrescribedDisplacement{}}};
  p.surface_loads = {constant_traction("end", boundary(model, "x_max"), {1e5, 0, -1e6})};
  return p;
}

TEST(InterfaceTractions, BalanceTheLoadOfABentBarAtEachInterface) {
  for (const Coupling coupling : all_couplings) {
    const ElasticityProblem p = cantilever({4, 1, 1}, 1);
    const ElasticitySolution solution = solve_elasticity(p, {.coupling = coupling});
    for (const InterfaceTraction& traction : interface_tractions(p, solution.multipliers)) {
      Eigen::Vector3d force = Eigen::Vector3d::Zero();
      Eigen::Vector3d moment = Eigen::Vector3d::Zero();
      double towards_the_end = 0;
      for (const InterfacePoint& point : points_of(p.discretization, traction)) {
        force += point.measure * point.traction;
        moment += point.measure * point.place.cross(point.traction);
        towards_the_end += point.measure * point.normal[0];
      }
      const double sign = towards_the_end > 0 ? 1 : -1;
      const Eigen::Vector3d load(1e5, 0, -1e6);
      EXPECT_LT((sign * force - load).norm(), 1e-8 * load.norm()) << name(coupling);
      const Eigen::Vector3d end = Eigen::Vector3d(4, 0.5, 0.5).cross(load);
      EXPECT_LT((sign * moment - end).norm(), 1e-7 * end.norm()) << name(coupling);
    }
  }
}

// Differences in the mean square over all interfaces, relative to the tractions themselves.
template <class Exact>
double relative_error(const Discretization& d, const std::vector<InterfaceTraction>& tractions,
                      const Exact& exact) {
  double error = 0;
  double size = 0;
  for (const InterfaceTraction& traction : tractions)
    for (const InterfacePoint& point : points_of(d, traction)) {
      const Eigen::Vector3d expected = exact(traction.interface, point);
      error += point.measure * (point.traction - expected).squaredNorm();
      size += point.measure * expected.squaredNorm();
    }
  return std::sqrt(error / size);
}

TEST(InterfaceTractions, ConvergeToAKnownStressNextToSupportsAndCrossLines) {
  // u = (x y z, x^2 z, x y^2) times 1e-3 vanishes with x.
  const auto sigma = [](const Eigen::Vector3d& x) {
    Eigen::Matrix3d gradient;
    gradient << x[1] * x[2], x[0] * x[2], x[0] * x[1], 2 * x[0] * x[2], 0, x[0] * x[0], x[1] * x[1],
        2 * x[0] * x[1], 0;
    gradient *= 1e-3;
    return Eigen::Matrix3d(stress(0.5 * (gradient + gradient.transpose()), soft));
  };
  // The body force by central differences, exact for a quadratic stress.
  const auto force = [sigma](const Eigen::Vector3d& x) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d step = 0.5 * Eigen::Vector3d::Unit(k);
      result -= (sigma(x + step) - sigma(x - step)).col(k);
    }
    return result;
  };
  std::vector<double> errors;
  for (int refine = 1; refine <= 2; ++refine) {
    ElasticityProblem p = problem(geometry::connect(geometry::box_model(
                                      {.patches = {2, 2, 2}, .distortion = 0.2, .orientation_seed = 9})),
                                  {.degree = {2, 2, 2}, .refine = refine}, soft);
    const auto& model = p.discretization.model;
    p.supports = {{"x_min", boundary(model, "x_min"), PrescribedDisplacement{}}};
    std::vector<PatchId> all;
    for (int i = 0; i < 8; ++i) all.emplace_back(i);
    p.volume_loads = {{"force", all, force}};
    for (const char* side : {"x_max", "y_min", "y_max", "z_min", "z_max"})
      p.surface_loads.push_back(
          {side, boundary(model, side), [sigma](const Eigen::Vector3d& x, const Eigen::Vector3d& n) {
             return Eigen::Vector3d(sigma(x) * n);
           }});
    const ElasticitySolution solution = solve_elasticity(p);
    errors.push_back(relative_error(p.discretization, interface_tractions(p, solution.multipliers),
                                    [&](int, const InterfacePoint& point) {
                                      return Eigen::Vector3d(sigma(point.place) * point.normal);
                                    }));
  }
  // Where the coefficients near edges continue linearly it is 1.8e-3, where they stay constant 1.9e-2.
  EXPECT_LT(errors[0], 0.01);
  EXPECT_LT(errors[1], 4.5e-4);
}

TEST(InterfaceTractions, ConvergeToTheStressesOfBothSidesInTheLink) {
  std::vector<double> first;
  std::vector<double> second;
  for (int refine = 1; refine <= 2; ++refine) {
    ElasticityProblem p =
        problem(geometry::connect(geometry::link_model()), {.degree = {2, 2, 2}, .refine = refine}, steel);
    const Discretization& d = p.discretization;
    p.supports = {{"bore", boundary(d.model, "bore_left"), PrescribedDisplacement{}}};
    p.surface_loads = {constant_traction("pull", boundary(d.model, "bore_right"), {1e6, -2e5, 0})};
    const ElasticitySolution solution = solve_elasticity(p);
    const auto tractions = interface_tractions(p, solution.multipliers);
    const auto side = [&](bool of_second) {
      return relative_error(d, tractions, [&](int i, const InterfacePoint& point) {
        const Interface& interface = d.model.interfaces()[static_cast<std::size_t>(i)];
        const PatchFace face = of_second ? interface.second : interface.first;
        const auto& patch = d.patches[static_cast<std::size_t>(face.patch.value)];
        const auto surface = geometry::face_surface(patch, face.side);
        const Parameter<2> scaled = of_second ? interface.orientation(point.scaled) : point.scaled;
        const Parameter<2> at = surface.low() + scaled.cwiseProduct(surface.high() - surface.low());
        const FieldValues values =
            evaluate(solution.field, face.patch.value, geometry::on_side(patch, face.side, at));
        EXPECT_LT((values.place - point.place).norm(), 1e-12 * d.model.size());
        return Eigen::Vector3d(values.stress * point.normal);
      });
    };
    first.push_back(side(false));
    second.push_back(side(true));
  }
  for (const auto& errors : {first, second}) {
    EXPECT_LT(errors[0], 0.36);
    EXPECT_LT(errors[1], 0.14);
  }
}

}  // namespace
}  // namespace isopatch::iga
