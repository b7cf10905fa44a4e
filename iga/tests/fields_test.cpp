#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <tuple>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/io/hdf5_writer.hpp"
#include "geometry/measures.hpp"
#include "geometry/models/elbow.hpp"
#include "iga/output/result_file.hpp"
#include "iga/problem/loads.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;
using geometry::Parameter;
using testing::boundary;
using testing::problem;

// A pipe elbow, clamped at its inlet and pulled aside at its outlet: rational patches with mixed degrees.
ElasticityProblem pulled_elbow() {
  ElasticityProblem p = problem(geometry::connect(geometry::elbow_model({})), {.degree = {2, 2, 2}},
                                isotropic(200, 0.3, 2.0, "soft"));
  const auto& model = p.discretization.model;
  p.supports = {{"inlet", boundary(model, "inlet"), PrescribedDisplacement{}}};
  p.surface_loads = {total_force("pull", boundary(model, "outlet"), {0, 0.1, 0}, p.discretization)};
  return p;
}

const ElasticitySolution& elbow_solution() {
  static const ElasticitySolution solution = solve_elasticity(pulled_elbow());
  return solution;
}

Parameter<3> inside(const NurbsVolume& patch, double u, double v, double w) {
  return patch.low() + (patch.high() - patch.low()).cwiseProduct(Parameter<3>(u, v, w));
}

TEST(ElasticField, LocatesItsOwnPoints) {
  const ElasticField& field = elbow_solution().field;
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    const NurbsVolume& patch = field.patches[p];
    const Parameter<3> parameter = inside(patch, 0.13, 0.71, 0.37);
    const Location found = locate(field, patch.point(parameter));
    EXPECT_EQ(found.patch, static_cast<int>(p));
    EXPECT_LT((found.parameter - parameter).norm(), 1e-9);
    EXPECT_LT(found.distance, 1e-11);
  }
  EXPECT_NEAR(locate(field, {0, 0, 1}).distance, 8, 1e-6)
      << "the axis of the inlet pipe is a bore radius away";
}

TEST(ElasticField, HasFiniteStressOnACollapsedEdge) {
  const NurbsVolume cube;
  Eigen::Matrix3Xd points = cube.control_points();
  for (int i = 0; i < 8; ++i)
    if (points(0, i) == 0) points(1, i) = 0.5;
  // u = (x, 0, 0) / 1000 everywhere.
  const Eigen::Matrix3Xd u = Eigen::Vector3d(1e-3, 0, 0).asDiagonal() * points;
  const ElasticField field{{NurbsVolume(cube.knots(), points)}, {u}, {isotropic(1000, 0)}};
  const FieldValues at = evaluate(field, 0, {0, 0.5, 0.5});
  EXPECT_NEAR(at.stress(0, 0), 1, 1e-9);
  EXPECT_NEAR(at.jacobian, 0, 1e-15);
}

TEST(ResultFile, ComesBackAsItWas) {
  const ElasticitySolution& solution = elbow_solution();
  const auto path = std::filesystem::temp_directory_path() / "isopatch_result_test.h5";
  const geometry::MultiPatch model = pulled_elbow().discretization.model;
  const geometry::PatchConnections connections = geometry::connections_of(model);
  write_file(path, to_hdf5({solution.field, solution.multipliers, connections, "title = \"x\"", "{}"}));
  const StoredResult back = read_result(path);
  std::filesystem::remove(path);
  ASSERT_EQ(back.field.patches.size(), solution.field.patches.size());
  for (std::size_t p = 0; p < back.field.patches.size(); ++p) {
    EXPECT_EQ(back.field.patches[p].knots(), solution.field.patches[p].knots());
    EXPECT_EQ(back.field.patches[p].control_points(), solution.field.patches[p].control_points());
    EXPECT_EQ(back.field.patches[p].weights(), solution.field.patches[p].weights());
    EXPECT_EQ(back.field.displacement[p], solution.field.displacement[p]);
    EXPECT_EQ(back.field.materials[p].mu, solution.field.materials[p].mu);
    EXPECT_EQ(back.field.materials[p].name, "soft");
  }
  ASSERT_EQ(back.multipliers.size(), solution.multipliers.size());
  EXPECT_EQ(back.multipliers.back().force, solution.multipliers.back().force);
  EXPECT_EQ(back.study, "title = \"x\"");
  const geometry::MultiPatch restored = model_of(back);
  EXPECT_EQ(restored.boundary_faces(), model.boundary_faces());
  EXPECT_EQ(restored.degenerate_faces(), model.degenerate_faces());
  ASSERT_EQ(restored.interfaces().size(), model.interfaces().size());
  for (std::size_t i = 0; i < restored.interfaces().size(); ++i) {
    EXPECT_EQ(restored.interfaces()[i].first, model.interfaces()[i].first);
    EXPECT_EQ(restored.interfaces()[i].second, model.interfaces()[i].second);
    EXPECT_EQ(restored.interfaces()[i].orientation, model.interfaces()[i].orientation);
    EXPECT_EQ(back.connections.interfaces[i].gap, model.interfaces()[i].gap);
  }
  EXPECT_EQ(back.connections.tolerance.same_point, model.tolerance().same_point);
  ASSERT_EQ(restored.boundaries().size(), model.boundaries().size());
  for (std::size_t b = 0; b < restored.boundaries().size(); ++b) {
    EXPECT_EQ(restored.boundaries()[b].name, model.boundaries()[b].name);
    EXPECT_EQ(restored.boundaries()[b].faces, model.boundaries()[b].faces);
  }
}

TEST(ResultFile, NumbersThatDoNotFitThePatchesAreNamedWithTheFile) {
  const ElasticitySolution& solution = elbow_solution();
  const auto connections = geometry::connections_of(pulled_elbow().discretization.model);
  const auto path = std::filesystem::temp_directory_path() / "isopatch_unfit_result_test.h5";
  const auto message_of = [&](const auto& change) {
    StoredResult result{solution.field, {}, connections, "", "{}"};
    change(result.field);
    write_file(path, to_hdf5(result));
    try {
      read_result(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_format);
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const auto names_file_and = [&](const std::string& what) {
    return ::testing::AllOf(::testing::HasSubstr(path.string()), ::testing::HasSubstr(what));
  };
  const auto cut = [](Eigen::Matrix3Xd& values, Eigen::Index by) {
    values.conservativeResize(3, values.cols() + by);
  };
  EXPECT_THAT(message_of([&](ElasticField& field) { cut(field.displacement.back(), -1); }),
              names_file_and("/patches/displacement ends early"));
  EXPECT_THAT(message_of([&](ElasticField& field) { cut(field.displacement.back(), 1); }),
              names_file_and("/patches/displacement has"));
  EXPECT_THAT(message_of([&](ElasticField& field) { field.materials.pop_back(); }),
              names_file_and("/patches/material has"));
  EXPECT_THAT(message_of([&](ElasticField& field) { field.patches.pop_back(); }),
              names_file_and("/patches/displacement has 324 columns, of which 297 belong to patches"));
  std::filesystem::remove(path);
}

TEST(ResultFile, StrainsByTemperatureThatDoNotFitThePatchesAreRefused) {
  const ElasticitySolution& solution = elbow_solution();
  StoredResult result{
      solution.field, {}, geometry::connections_of(pulled_elbow().discretization.model), "", "{}"};
  result.field.thermal.assign(result.field.patches.size() + 1, {1e-3, Eigen::Vector3d::Zero()});
  const auto path = std::filesystem::temp_directory_path() / "isopatch_thermal_result_test.h5";
  write_file(path, to_hdf5(result));
  EXPECT_ERROR(read_result(path), ErrorCode::bad_format,
               std::to_string(result.field.thermal.size()) + " columns for " +
                   std::to_string(result.field.patches.size()) + " patches");
  std::filesystem::remove(path);
}

TEST(ResultFile, OfAnotherProgramOrVersionIsRefused) {
  const auto path = std::filesystem::temp_directory_path() / "isopatch_foreign_result_test.h5";
  geometry::Hdf5Writer file;
  file.write("/format", "isopatch result");
  file.write("/version", std::int64_t{987});
  write_file(path, file.image());
  EXPECT_ERROR(read_result(path), ErrorCode::unsupported, "results in format 987, this program reads format");
  geometry::Hdf5Writer foreign;
  foreign.write("/format", "something else");
  write_file(path, foreign.image());
  EXPECT_ERROR(read_result(path), ErrorCode::bad_format, "not a result of isopatch");
  std::filesystem::remove(path);
}

// Whatever a changed bit does to a file of results: an error, or the same results.
TEST(ResultFile, NoChangedBitGivesOtherResults) {
  const ElasticitySolution& solution = elbow_solution();
  const auto connections = geometry::connections_of(pulled_elbow().discretization.model);
  const std::string good =
      to_hdf5({solution.field, solution.multipliers, connections, "title = \"x\"", "{}"});
  const auto path = std::filesystem::temp_directory_path() / "isopatch_changed_result_test.h5";
  int noticed = 0;
  for (std::size_t n = 0; n < 150; ++n) {
    const std::size_t at = n * 7919 * 131 % good.size();
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 1 << n % 8);
    std::ofstream(path, std::ios::binary) << bad;
    try {
      EXPECT_EQ(to_hdf5(read_result(path)), good) << at;
    } catch (const Error& error) {
      EXPECT_NE(error.code(), ErrorCode::invalid_argument) << error.what();
      ++noticed;
    }
  }
  std::filesystem::remove(path);
  EXPECT_GT(noticed, 40);  // the others are in bytes that mean nothing
}

TEST(Loads, HaveTheResultantsOfTheirKind) {
  ElasticityProblem p = pulled_elbow();
  const auto& model = p.discretization.model;
  EXPECT_LT((load_vector(p).rowwise().sum() - Eigen::Vector3d(0, 0.1, 0)).norm(), 1e-11);
  // Pressure on the whole closed surface has no resultant; on the outlet, a plane face looking to +x, it has
  // area times pressure.
  p.surface_loads = {pressure_load("all around", model.boundary_faces(), 3)};
  const Eigen::Matrix3Xd closed = load_vector(p, 6);
  EXPECT_LT(closed.rowwise().sum().norm(), 1e-8 * closed.cwiseAbs().sum());
  p.surface_loads = {pressure_load("outlet", boundary(model, "outlet"), 3)};
  EXPECT_LT((load_vector(p).rowwise().sum() - Eigen::Vector3d(-3 * M_PI * 36, 0, 0)).norm(), 1e-3);
  p.surface_loads.clear();
  std::vector<PatchId> all;
  double volume = 0;
  for (int i = 0; i < model.patch_count(); ++i) {
    all.emplace_back(i);
    volume += geometry::volume(model.patches()[static_cast<std::size_t>(i)]);
  }
  p.volume_loads = gravity("weight", all, {0, 0, -9.81}, p.materials);
  EXPECT_NEAR(load_vector(p, 8).rowwise().sum()[2] / (-9.81 * 2.0 * volume), 1, 1e-9);
}

TEST(Loads, NeedABoundaryFaceAndADensity) {
  ElasticityProblem p = pulled_elbow();
  p.surface_loads[0].faces = {p.discretization.model.interfaces()[0].first};
  EXPECT_ERROR(load_vector(p), ErrorCode::invalid_argument, "is not on the boundary");
  p.materials[0].density = 0;
  EXPECT_ERROR(gravity("weight", {PatchId(0)}, {0, 0, -1}, p.materials), ErrorCode::invalid_argument,
               "patch 0 has no density");
}

TEST(Reactions, BalanceLoadsAndTheirMoments) {
  const ElasticitySolution& solution = elbow_solution();
  const Eigen::Vector3d force = solution.results.reactions[0].force;
  EXPECT_LT((force + Eigen::Vector3d(0, 0.1, 0)).norm(), 1e-9);
  // The outlet's centre is at x = bend radius + outlet length, z = inlet length + bend radius.
  const Eigen::Vector3d moment = Eigen::Vector3d(35, 0, 35).cross(Eigen::Vector3d(0, 0.1, 0));
  EXPECT_LT((solution.results.reactions[0].moment + moment).norm(), 1e-3 * moment.norm());
  EXPECT_NEAR(solution.results.external_work / solution.results.internal_energy, 1, 1e-9);
}

TEST(Material, RefusesWhatIsNoStiffness) {
  EXPECT_NEAR(poisson(isotropic(7, 0.3)), 0.3, 1e-15);
  EXPECT_NEAR(young(isotropic(7, 0.3)), 7, 1e-14);
  struct Case {
    double e, nu;
    const char* words;
  };
  for (const Case& c : std::vector<Case>{{0, 0.3, "Young's modulus is 0 Pa"},
                                         {-1, 0.3, "Young's modulus is -1 Pa"},
                                         {1, 0.5, "incompressible"},
                                         {1, 0.7, "Poisson's ratio is 0.7"},
                                         {1, -1, "Poisson's ratio is -1"},
                                         {NAN, 0.1, "Young's modulus is nan Pa"},
                                         {1, NAN, "Poisson's ratio is nan"}})
    EXPECT_ERROR(isotropic(c.e, c.nu), ErrorCode::invalid_argument, c.words) << c.e << " " << c.nu;
  try {
    isotropic(1, 0.5);
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("incompressible"));
  }
}

}  // namespace
}  // namespace isopatch::iga
