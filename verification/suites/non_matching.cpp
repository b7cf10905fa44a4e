// Patches whose faces are one surface, but whose elements, parameters or outlines there do not agree: linear
// fields must go through such interfaces unchanged, waves with the order of matching ones.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/link.hpp"
#include "geometry/quadrature.hpp"
#include "iga/solution/natural_modes.hpp"
#include "iga/spaces/element_tables.hpp"
#include "iga/spaces/multiplier_space.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/known_problem.hpp"
#include "verification/suites/known_problems.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/moved_patches.hpp"
#include "verification/suites/several_processes.hpp"

namespace isopatch::verification {
namespace {

using geometry::MultiPatch;
using iga::Coupling;
using iga::NonMatchingCoupling;

const Tolerance of_plane_interfaces = round_off(3e4, "assembling and solving");
// 1.6e-10 at p = 3.
const Tolerance of_curved_interfaces(1e-9, "quadrature of rational functions");

// Elements of the other side that are not straight in the slave's parameters: 1.6e-7.
const Tolerance of_clipped_cells(1e-6, "cells of the common refinement near lines that are not straight");

struct NonMatchingModel {
  std::string name;
  MultiPatch model;
  std::vector<std::string> held;
  bool has_two_covered_sides = true;
};

MultiPatch kept_apart(const geometry::PatchSet& below, const geometry::PatchSet& above) {
  return geometry::connect(together(below, above), {.keep_non_matching = true});
}

// Two boxes of 2 x 1, one on the other, of so many patches; what is regular has lines of elements that meet
// the other box's at no angle.
MultiPatch boxes(std::array<int, 3> below, std::array<int, 3> above, double distortion) {
  return kept_apart(
      geometry::box_model({.size = {2, 1, 1}, .patches = below, .distortion = distortion, .seed = 3}),
      geometry::box_model(
          {.size = {2, 1, 0.8}, .origin = {0, 0, 1}, .patches = above, .distortion = distortion, .seed = 8}));
}

// A tube's sector of two layers, divided into other arcs in each: the same cylinder in other rational
// parameters.
MultiPatch layers(int inside, int outside, double degrees = 60) {
  const auto layer = [&](double from, double to, int patches) {
    return geometry::cylinder_model({.inner_radius = from,
                                     .outer_radius = to,
                                     .height = 0.5,
                                     .angle = Angle::degrees(degrees),
                                     .patches_around = patches});
  };
  return kept_apart(layer(1.5, 2, inside), layer(2, 2.4, outside));
}

std::vector<NonMatchingModel> models() {
  return {{"T-joint", boxes({1, 1, 1}, {2, 1, 1}, 0), {"x_min", "y_max, second"}},
          {"distorted T-joint", boxes({1, 1, 1}, {2, 1, 1}, 0.2), {"x_min", "y_max, second"}},
          {"3 patches on 2", boxes({2, 1, 1}, {3, 1, 1}, 0.1), {"x_min", "y_max, second"}},
          {"arcs", layers(1, 2), {"start", "bottom, second"}},
          {"3 arcs around 2", layers(2, 3), {"start", "bottom, second"}}};
}

bool is_curved(const NonMatchingModel& model) {
  return model.model.patch(PatchId(0)).is_rational();
}

iga::ElasticityProblem pulled(const NonMatchingModel& m, const LinearField& field, int degree,
                              int refine = 1) {
  const iga::Material material = iga::isotropic(1e9, 0.3);
  iga::ElasticityProblem p =
      unloaded(m.model, {.degree = {degree, degree, degree}, .refine = refine}, material);
  p.supports = {{m.held[0], faces_of(m.model, m.held[0]), field.prescribed()}};
  std::vector<geometry::PatchFace> loaded = m.model.boundary_faces();
  for (const geometry::PatchFace& face : p.supports[0].faces) std::erase(loaded, face);
  p.surface_loads = {{"stress", loaded,
                      [stress = field.stress(material)](const Eigen::Vector3d&, const Eigen::Vector3d& n)
                          -> Eigen::Vector3d { return stress * n; }}};
  return p;
}

// Both couplings of what matches by Nitsche's method, and with mortar multipliers on either side that can
// have them.
std::vector<iga::ElasticityOptions> ways(const NonMatchingModel& m) {
  std::vector<iga::ElasticityOptions> result;
  for (const Coupling coupling : iga::all_couplings) {
    result.push_back({.coupling = coupling});
    result.push_back({.coupling = coupling, .non_matching = NonMatchingCoupling::mortar});
  }
  if (m.has_two_covered_sides)
    result.push_back({.non_matching = NonMatchingCoupling::mortar, .mortar_side = iga::MortarSide::other});
  return result;
}

std::string words(const iga::ElasticityOptions& way) {
  return fmt::format("{}, {}{}", iga::name(way.coupling), iga::name(way.non_matching),
                     way.mortar_side == iga::MortarSide::other ? " on the other side" : "");
}

void expect_linear(const NonMatchingModel& m, const iga::ElasticityOptions& way, const std::string& of,
                   const iga::ElasticField& found, const LinearField& field) {
  expect(Claim{of + ": largest error of a coefficient of u",
               "",
               ReferenceKind::exact,
               "linear field",
               0,
               coefficient_error(found, field),
               is_curved(m)                                    ? of_curved_interfaces
               : way.mortar_side == iga::MortarSide::automatic ? of_plane_interfaces
                                                               : of_clipped_cells,
               {}});
}

TEST(NonMatching, LinearFields) {
  const LinearField field = generic_linear_field();
  for (const NonMatchingModel& m : models())
    for (const int degree : {1, 2, 3}) {
      if (is_curved(m) && degree < 2) continue;
      for (const iga::ElasticityOptions& way : ways(m)) {
        const iga::ElasticitySolution solution = iga::solve_elasticity(pulled(m, field, degree), way);
        const std::string of = fmt::format("{}, p = {}, {}", m.name, degree, words(way));
        const bool is_mortar = way.non_matching == NonMatchingCoupling::mortar;
        // On curved faces the traction of a linear field is no multiplier.
        if (is_mortar && is_curved(m)) continue;
        expect_linear(m, way, of, solution.field, field);
      }
    }
}

// A small sector beside the wave: on larger ones coarse meshes converge faster than they will in the end.
NonMatchingModel small_arcs() {
  return {"arcs", layers(1, 2, 20), {"start", "bottom, second"}};
}

void expect_orders_of(const NonMatchingModel& m, const Levels& levels) {
  expect_orders(manufactured(m.name, m.model, m.held), levels);
}

// Evenly warm, with the tractions of the stresses that are left: the same displacements.
TEST(NonMatching, LinearFieldsOfWarmParts) {
  const LinearField field = generic_linear_field();
  for (const NonMatchingModel& m : models())
    for (const iga::ElasticityOptions& way : ways(m)) {
      if (is_curved(m) && way.non_matching == NonMatchingCoupling::mortar) continue;
      iga::ElasticityProblem p = pulled(m, field, 2);
      const double strain = 1.2e-3;
      for (iga::Material& material : p.materials) material.expansion = strain / 100;
      const iga::Material material = p.materials.front();
      p.temperatures = {{"warm", all_patches(m.model), {100, Eigen::Vector3d::Zero()}}};
      const Eigen::Matrix3d left =
          iga::stress(field.strain() - strain * Eigen::Matrix3d::Identity(), material);
      p.surface_loads.front().traction =
          [left](const Eigen::Vector3d&, const Eigen::Vector3d& n) -> Eigen::Vector3d { return left * n; };
      const iga::ElasticitySolution solution = iga::solve_elasticity(p, way);
      const std::string of = fmt::format("warm {}, {}", m.name, words(way));
      expect_linear(m, way, of, solution.field, field);
      const iga::ElasticityResults& r = solution.results;
      expect(Claim{of + ": energy of part and interfaces over the work of loads and temperatures",
                   "",
                   ReferenceKind::exact,
                   "balance",
                   1,
                   (r.internal_energy + r.interface_energy) / (r.external_work + r.thermal_work),
                   round_off(1e6, "assembling and solving"),
                   {}});
    }
}

// Where temperature is linear in the place a part that is free grows without stress.
TEST(NonMatching, FreePartsGrowWithoutStress) {
  const NonMatchingModel m = models().front();
  for (const NonMatchingCoupling non_matching : {NonMatchingCoupling::nitsche, NonMatchingCoupling::mortar}) {
    iga::ElasticityProblem p = pulled(m, {}, 2);
    for (iga::Material& material : p.materials) material.expansion = 1e-5;
    p.supports = {{"rest", {}, iga::FreeBodySupport{}}};
    p.surface_loads.clear();
    p.temperatures = {{"warm", all_patches(m.model), {50, {30, -20, 10}}}};
    const iga::ElasticitySolution solution = iga::solve_elasticity(p, {.non_matching = non_matching});
    expect(Claim{
        fmt::format("free T-joint, {}: largest von Mises stress over E alpha 50 K", iga::name(non_matching)),
        "",
        ReferenceKind::exact,
        "no stress",
        0,
        solution.results.max_von_mises.value / (1e9 * 1e-5 * 50),
        of_plane_interfaces,
        {}});
  }
}

// The frequencies of two patches on one against those of two on two.
TEST(NonMatching, FrequenciesAreThoseOfMatchingPatches) {
  const auto frequencies = [](const MultiPatch& model) {
    iga::Material material = iga::isotropic(1e9, 0.3);
    material.density = 1000;
    iga::ElasticityProblem p = unloaded(model, {.degree = {3, 3, 3}, .refine = 1}, material);
    std::vector<double> result;
    for (const iga::NaturalMode& mode : iga::natural_modes(p, {.number = 6}).modes)
      if (!mode.is_rigid) result.push_back(mode.frequency);
    return result;
  };
  const std::vector<double> reference = frequencies(boxes({2, 1, 1}, {2, 1, 1}, 0));
  const std::vector<double> ours = frequencies(boxes({1, 1, 1}, {2, 1, 1}, 0));
  ASSERT_EQ(ours.size(), reference.size());
  for (std::size_t i = 0; i < ours.size(); ++i)
    expect(Claim{fmt::format("frequency {} of a free box with a T-joint", i + 1),
                 "Hz",
                 ReferenceKind::other_method,
                 "matching patches, degree 3",
                 reference[i],
                 ours[i],
                 {4e-3, "elements twice as long in one half"},
                 {}});
}

// With mortar multipliers a linear field comes through a curved interface as well as its traction does among
// them.
TEST(NonMatching, MortarOnCurvedInterfacesConverges) {
  const LinearField field = generic_linear_field();
  for (const NonMatchingModel& m : models()) {
    if (!is_curved(m)) continue;
    for (const int degree : {2, 3}) {
      std::vector<double> errors;
      for (const int refine : {1, 2, 3}) {
        iga::ElasticityProblem p = pulled(m, field, degree, refine);
        errors.push_back(coefficient_error(
            iga::solve_elasticity(p, {.non_matching = NonMatchingCoupling::mortar}).field, field));
      }
      EXPECT_LT(errors[1], errors[0] / std::pow(2, degree - 0.5)) << m.name << ", p = " << degree;
      EXPECT_LT(errors[2], errors[1] / std::pow(2, degree - 0.5)) << m.name << ", p = " << degree;
      EXPECT_LT(errors[2], 2e-5) << m.name << ", p = " << degree;
    }
  }
}

// A part of two materials: the differences of two ways to couple are errors of the discretization.
iga::ElasticityProblem bent(const NonMatchingModel& m, int degree, int refine) {
  iga::ElasticityProblem p =
      unloaded(m.model, {.degree = {degree, degree, degree}, .refine = refine, .spread = false},
               iga::isotropic(1e9, 0.3));
  p.materials.back() = iga::isotropic(3e9, 0.2);
  p.supports = {{m.held[0], faces_of(m.model, m.held[0]), iga::PrescribedDisplacement{}}};
  p.surface_loads = {{"push", faces_of(m.model, m.held[1]),
                      [](const Eigen::Vector3d&, const Eigen::Vector3d&) -> Eigen::Vector3d {
                        return {1e5, 2e5, -1e5};
                      }}};
  return p;
}

double energy(const iga::ElasticityProblem& p, const iga::ElasticityOptions& way) {
  const iga::ElasticityResults results = iga::solve_elasticity(p, way).results;
  return results.internal_energy + results.interface_energy;
}

double difference_of_energies(const NonMatchingModel& m, int refine, const iga::ElasticityOptions& way) {
  const iga::ElasticityProblem p = bent(m, 2, refine);
  const double first = energy(p, {});
  return std::abs(energy(p, way) - first) / first;
}

TEST(NonMatching, WaysAgreeWithinTheErrorOfTheDiscretization) {
  for (const NonMatchingModel& m : models()) {
    const iga::ElasticityProblem p = bent(m, 2, 2), finer = bent(m, 2, 3);
    const double first = energy(p, {});
    const double of_first = std::abs(energy(finer, {}) - first) / first;
    for (const iga::ElasticityOptions& way : ways(m)) {
      if (way == iga::ElasticityOptions{} || way.mortar_side == iga::MortarSide::other) continue;
      const double second = energy(p, way);
      const double of_second = std::abs(energy(finer, way) - second) / first;
      expect(Claim{fmt::format("{}: energy, {}", m.name, words(way)),
                   "J",
                   ReferenceKind::other_method,
                   "Nitsche's method, to four thirds of what the next refinement changes in both",
                   first,
                   second,
                   Tolerance(4. / 3 * (of_first + of_second), "the discretization's errors"),
                   {}});
    }
  }
}

// A coarse slave gives way by as much as a fine one is too stiff: both come to one limit.
TEST(NonMatching, SidesComeToOneLimit) {
  const iga::ElasticityOptions other{.non_matching = NonMatchingCoupling::mortar,
                                     .mortar_side = iga::MortarSide::other};
  for (const NonMatchingModel& m : models()) {
    const double coarse = difference_of_energies(m, 2, other), fine = difference_of_energies(m, 3, other);
    EXPECT_LT(coarse, 0.15) << m.name;
    EXPECT_LT(fine, 0.6 * coarse) << m.name;
  }
}

// What the slaves' faces get is what the loads and the support put on their patches.
TEST(NonMatching, MortarForcesBalance) {
  for (const NonMatchingModel& m : models())
    for (const iga::MortarSide side : {iga::MortarSide::automatic, iga::MortarSide::other}) {
      if (side == iga::MortarSide::other && !m.has_two_covered_sides) continue;
      const iga::ElasticitySolution solution = iga::solve_elasticity(
          bent(m, 2, 1), {.non_matching = NonMatchingCoupling::mortar, .mortar_side = side});
      const iga::ElasticityResults& results = solution.results;
      Eigen::Vector3d across = Eigen::Vector3d::Zero();
      for (const iga::MortarTie& tie : solution.mortar) across += tie.force;
      const std::string of =
          fmt::format("{}, {}", m.name, side == iga::MortarSide::other ? "other side" : "side");
      expect(Claim{of + ": sum of support and loads",
                   "N",
                   ReferenceKind::exact,
                   "equilibrium",
                   0,
                   (results.reactions[0].force + results.total_load).norm() / results.total_load.norm(),
                   round_off(3e5, "assembling and solving"),
                   {}});
      // One of the two sides is held and the other is loaded, or both are on one.
      const double through = smaller(
          smaller((across - results.total_load).norm(), (across + results.total_load).norm()), across.norm());
      expect(Claim{of + ": force across the interface",
                   "N",
                   ReferenceKind::exact,
                   "equilibrium",
                   0,
                   through / results.total_load.norm(),
                   round_off(3e5, "assembling and solving"),
                   {}});
      expect(Claim{of + ": energy over work",
                   "",
                   ReferenceKind::exact,
                   "constraints do no work",
                   1,
                   results.internal_energy / results.external_work,
                   round_off(3e5, "assembling and solving"),
                   {}});
    }
}

void expect_orders_of(const NonMatchingModel& m, Levels levels, NonMatchingCoupling way) {
  levels.non_matching = way;
  expect_orders_of(m, levels);
}

constexpr std::array both_ways = {NonMatchingCoupling::nitsche, NonMatchingCoupling::mortar};

TEST(NonMatching, Orders) {
  for (const NonMatchingCoupling way : both_ways) {
    for (const NonMatchingModel& m : models())
      if (!is_curved(m)) expect_orders_of(m, {1, {4, 6, 8, 12}}, way);
    expect_orders_of(models()[1], {2, {6, 8, 10, 12}}, way);
  }
}

TEST(FullNonMatching, Orders) {
  for (const NonMatchingCoupling way : both_ways) {
    const bool is_mortar = way == NonMatchingCoupling::mortar;
    for (const NonMatchingModel& m : models()) {
      if (is_curved(m)) continue;
      if (!is_mortar || m.name != "3 patches on 2") expect_orders_of(m, {2, {6, 8, 10, 12}}, way);
      expect_orders_of(m, {3, {4, 6, 8, 10}}, way);
    }
    expect_orders_of(small_arcs(), {1, {6, 8, 12, 16}}, way);
    if (!is_mortar) expect_orders_of(small_arcs(), {2, {6, 8, 10, 12}}, way);
    expect_orders_of(small_arcs(), {3, {4, 6, 8, 10}}, way);
    expect_orders_of(small_arcs(), {4, {6, 8, 10, 12}}, way);
  }
}

// With quadratic multipliers they come from above slowly: 3.2 where 3 is the order in the end, at sixteen
// elements a side.
TEST(FullNonMatching, OrdersOfQuadraticMultipliersOnPlanes) {
  expect_orders_of(models()[2], {.degree = 2, .elements = {20, 22, 24, 26}, .iterate = true},
                   NonMatchingCoupling::mortar);
}

TEST(FullNonMatching, OrdersOfQuadraticMultipliersOnArcs) {
  expect_orders_of(small_arcs(), {.degree = 2, .elements = {26, 28, 30, 32}, .iterate = true},
                   NonMatchingCoupling::mortar);
}

// The distorted T-joint comes from above: 5.16 for 5 between ten and twelve elements a side with six at
// first.
TEST(FullNonMatching, OrdersOfDegree4) {
  for (const NonMatchingCoupling way : both_ways) {
    expect_orders_of(models()[2], {4, {6, 8, 10, 12}}, way);
    expect_orders_of(models()[1], {4, {8, 10, 12, 14}}, way);
  }
}

// As many as the same patches take that match, and at most half as many more.
TEST(NonMatching, IterationsAreLikeThoseOfMatchingPatches) {
  const geometry::PatchSet link = geometry::link_model();
  const MultiPatch model = geometry::connect(link, {.keep_non_matching = true});
  for (const int degree : {1, 2, 3}) {
    const iga::DiscretizationOptions matching{
        .degree = {degree, degree, degree}, .elements_per_direction = {4, 4, 4}, .spread = false};
    iga::DiscretizationOptions apart = matching;
    apart.patches = {{.patches = {1, 3, 5, 7, 9}, .elements_per_direction = {5, 5, 5}}};
    const auto iterations = [&](const iga::DiscretizationOptions& elements, NonMatchingCoupling way) {
      iga::ElasticityProblem p = unloaded(model, elements, iga::isotropic(210e9, 0.3));
      p.supports = {{"held", faces_of(model, "bore_left"), {}}};
      p.surface_loads = {{"pull", faces_of(model, "bore_right"),
                          [](const Eigen::Vector3d&, const Eigen::Vector3d&) -> Eigen::Vector3d {
                            return {1e6, -2e5, 1e5};
                          }}};
      iga::ElasticityOptions options{.non_matching = way};
      options.solver.method = solvers::Method::cg;
      options.solver.tolerance = 1e-10;
      return iga::solve_elasticity(p, options).solver.iterations;
    };
    const int usual = iterations(matching, NonMatchingCoupling::nitsche);
    for (const NonMatchingCoupling way : both_ways)
      expect(Claim{fmt::format("link apart, p = {}, {}: iterations", degree, iga::name(way)),
                   "",
                   ReferenceKind::other_method,
                   "1.5 times those of the matching model",
                   1.5 * usual,
                   static_cast<double>(iterations(apart, way)),
                   0,
                   {},
                   Comparison::at_most,
                   1.});
  }
}

// The least ratio of sup (m, v) / |v| to |m| over multipliers of a line of unit length, in L2, where v is 0
// at both ends. Products of two lines have the product of their constants.
double inf_sup(int held, const geometry::KnotVector& knots, const Eigen::MatrixXd& multipliers,
               const geometry::KnotVector& of_multipliers) {
  const iga::DirectionTable v = iga::direction_table(knots, geometry::gauss_legendre(knots.degree() + 1));
  const iga::DirectionTable m =
      iga::direction_table(of_multipliers, geometry::gauss_legendre(knots.degree() + 1));
  Eigen::MatrixXd vv = Eigen::MatrixXd::Zero(knots.size(), knots.size());
  Eigen::MatrixXd mm = Eigen::MatrixXd::Zero(of_multipliers.size(), of_multipliers.size());
  Eigen::MatrixXd mv = Eigen::MatrixXd::Zero(of_multipliers.size(), knots.size());
  for (std::size_t e = 0; e < v.elements.size(); ++e) {
    const auto& of_v = v.elements[e];
    const auto& of_m = m.elements[e];
    const Eigen::MatrixXd weighted = of_m.weights.asDiagonal() * of_m.values;
    const Eigen::Index p = of_v.values.cols(), q = of_m.values.cols();
    vv.block(of_v.first, of_v.first, p, p) +=
        of_v.values.transpose() * of_v.weights.asDiagonal() * of_v.values;
    mm.block(of_m.first, of_m.first, q, q) += of_m.values.transpose() * weighted;
    mv.block(of_m.first, of_v.first, q, p) += weighted.transpose() * of_v.values;
  }
  const Eigen::Index inner = knots.size() - 2 * held;
  const Eigen::MatrixXd b = (multipliers.transpose() * mv).middleCols(held, inner);
  const Eigen::MatrixXd schur = b * vv.block(held, held, inner, inner).ldlt().solve(b.transpose());
  const double least = symmetric_eigen(schur, multipliers.transpose() * mm * multipliers).values[0];
  return std::sqrt(larger(0.0, least));
}

geometry::KnotVector lowered(const geometry::KnotVector& knots) {
  return geometry::KnotVector::uniform(knots.degree() - 1, knots.element_count());
}

Figure stability(const std::string& what, double value) {
  Figure figure;
  figure.what = what;
  figure.kind = ReferenceKind::other_method;
  figure.source = "least singular value";
  figure.value = value;
  figure.why = "stable as long as it does not fall with the elements";
  return figure;
}

TEST(NonMatching, MultipliersAreStable) {
  for (const int degree : {1, 2, 3, 4}) {
    double coarse = 0, fine = 0;
    for (const int elements : {4, 8, 16, 32, 64}) {
      const geometry::KnotVector knots = geometry::KnotVector::uniform(degree, elements);
      const double ours = inf_sup(1, knots, iga::multiplier_coefficients(knots, {true, true}), knots);
      report(stability(
          fmt::format("inf-sup constant of a line's multipliers, p = {}, {} elements", degree, elements),
          ours));
      coarse = elements == 4 ? ours : coarse;
      fine = ours;
    }
    EXPECT_GT(fine, 0.9 * coarse) << "p = " << degree;
  }
}

// Splines of one degree less have multipliers with alternating signs that hardly anything feels: the constant
// falls as elements get smaller.
TEST(NonMatching, MultipliersOfOneDegreeLessAreNot) {
  for (const int degree : {2, 3, 4}) {
    std::vector<double> constants;
    for (const int elements : {8, 16, 32}) {
      const geometry::KnotVector knots = geometry::KnotVector::uniform(degree, elements);
      const geometry::KnotVector lower = lowered(knots);
      constants.push_back(inf_sup(0, knots, Eigen::MatrixXd::Identity(lower.size(), lower.size()), lower));
      report(stability(fmt::format("inf-sup constant with multipliers of degree p - 1, p = {}, {} elements",
                                   degree, elements),
                       constants.back()));
    }
    EXPECT_LT(constants[2], 0.8 * constants[1]) << "p = " << degree;
    EXPECT_LT(constants[1], 0.8 * constants[0]) << "p = " << degree;
  }
}

class NonMatchingParallel : public SeveralProcesses {};

// Every interface is one process' affair, and the figures are those of one process.
TEST_F(NonMatchingParallel, AreTheSame) {
  const Tolerance same = {1e-8, "iterations"};
  for (const std::string coupling : {"nitsche", "mortar"}) {
    const std::string non_matching = fmt::format("coupling.non_matching='{}'", coupling);
    for (const std::string method : {"mumps", "cg"})
      expect_same_energy_of("uneven_link", {non_matching},
                            {fmt::format("solver.method='{}'", method), "solver.tolerance=1e-11"}, same);
    expect_same_energy_of("uneven_link", {non_matching},
                          {"coupling.method='lagrange'", "solver.method='minres'", "solver.tolerance=1e-10"},
                          same);
  }
}

}  // namespace
}  // namespace isopatch::verification
