// Sums over elements by sum factorization, held against plain tables of all functions at all points.

#include <gtest/gtest.h>
#include <omp.h>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/elbow.hpp"
#include "geometry/splines/grid.hpp"
#include "iga/post/internal_forces.hpp"
#include "iga/post/results.hpp"
#include "iga/problem/loads.hpp"
#include "iga/spaces/element.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using testing::problem;

// Rational patches of mixed degrees, several elements in each direction, two materials.
ElasticityProblem elbow_of_two_materials() {
  ElasticityProblem p = problem(geometry::connect(geometry::elbow_model({})),
                                {.degree = {3, 2, 2}, .refine = 1}, isotropic(200, 0.3, 2.0));
  p.materials[1] = isotropic(70, 0.2, 3.0);
  return p;
}

Eigen::Matrix3Xd some_displacement(const Discretization& d) {
  Eigen::Matrix3Xd u(3, d.node_count());
  for (std::size_t p = 0; p < d.patches.size(); ++p)
    u.middleCols(d.first_node[p], d.patches[p].size()) =
        (0.3 * d.patches[p].control_points()).array().sin().matrix() * 1e-3;
  return u;
}

// Visits every element with the table of its functions.
template <class Visit>
void for_each_table(const Discretization& d, Visit visit) {
  ElementValues values;
  for (std::size_t p = 0; p < d.patches.size(); ++p) {
    const ElementEvaluator evaluator(d.patches[p], gauss_rules(d.gauss_points[p]));
    for (std::int64_t e = 0; e < evaluator.element_count(); ++e) {
      evaluator.evaluate(e, values);
      visit(p, values);
    }
  }
}

TEST(InternalForces, AreThoseOfPlainTables) {
  const ElasticityProblem p = elbow_of_two_materials();
  const Discretization& d = p.discretization;
  const Eigen::Matrix3Xd u = some_displacement(d);
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, d.node_count());
  double energy = 0;
  double largest = 0;
  for_each_table(d, [&](std::size_t patch, const ElementValues& values) {
    for (Eigen::Index q = 0; q < values.measures.size(); ++q) {
      Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
      for (std::size_t a = 0; a < values.functions.size(); ++a)
        for (int j = 0; j < 3; ++j)
          gradient.col(j) += u.col(d.first_node[patch] + values.functions[a]) *
                             values.gradients[static_cast<std::size_t>(j)](static_cast<Eigen::Index>(a), q);
      const Eigen::Matrix3d strain = 0.5 * (gradient + gradient.transpose());
      const Eigen::Matrix3d sigma = stress(strain, p.materials[patch]);
      energy += 0.5 * values.measures[q] * sigma.cwiseProduct(strain).sum();
      largest = isopatch::larger(largest, von_mises(sigma));
      for (std::size_t a = 0; a < values.functions.size(); ++a)
        for (int j = 0; j < 3; ++j)
          forces.col(d.first_node[patch] + values.functions[a]) +=
              values.measures[q] *
              values.gradients[static_cast<std::size_t>(j)](static_cast<Eigen::Index>(a), q) * sigma.col(j);
    }
  });
  const InternalForces found = internal_forces(d, p.materials, u);
  // Some thousand additions of round-off: 1e-12 is far above them.
  EXPECT_LT((found.forces - forces).norm(), 1e-12 * forces.norm());
  EXPECT_NEAR(found.energy / energy, 1, 1e-12);
  EXPECT_NEAR(found.max_von_mises.value / largest, 1, 1e-12);
  ElasticField field{d.patches, {}, p.materials};
  for (std::size_t i = 0; i < d.patches.size(); ++i)
    field.displacement.push_back(u.middleCols(d.first_node[i], d.patches[i].size()));
  const FieldValues there = evaluate(field, found.max_von_mises.patch, found.max_von_mises.parameter);
  EXPECT_NEAR(there.von_mises / largest, 1, 1e-10);
  EXPECT_LT((there.place - found.max_von_mises.place).norm(), 1e-12 * d.model.size());
}

TEST(Loads, OfVolumesAreThoseOfPlainTables) {
  ElasticityProblem p = elbow_of_two_materials();
  const Discretization& d = p.discretization;
  const auto force = [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x[1] * x[2], 1 + x[0], std::cos(x[1]));
  };
  std::vector<PatchId> all;
  for (int i = 0; i < d.patch_count(); ++i) all.emplace_back(i);
  p.volume_loads = {{"field", all, force}};
  Eigen::Matrix3Xd load = Eigen::Matrix3Xd::Zero(3, d.node_count());
  for_each_table(d, [&](std::size_t patch, const ElementValues& values) {
    for (Eigen::Index q = 0; q < values.measures.size(); ++q)
      for (std::size_t a = 0; a < values.functions.size(); ++a)
        load.col(d.first_node[patch] + values.functions[a]) +=
            values.measures[q] * values.values(static_cast<Eigen::Index>(a), q) * force(values.places.col(q));
  });
  EXPECT_LT((load_vector(p) - load).norm(), 1e-12 * load.norm());
  p.volume_loads[0].force = [](const Eigen::Vector3d&) { return Eigen::Vector3d(0, NAN, 0); };
  EXPECT_ERROR(load_vector(p), ErrorCode::invalid_argument, "is not finite");
}

TEST(MaxDisplacement, IsTheLargestOfTheGrid) {
  const ElasticityProblem p = elbow_of_two_materials();
  const Discretization& d = p.discretization;
  const Eigen::Matrix3Xd u = some_displacement(d);
  ElasticField field{d.patches, {}, p.materials};
  double largest = 0;
  for (std::size_t i = 0; i < d.patches.size(); ++i) {
    const geometry::NurbsVolume& patch = d.patches[i];
    field.displacement.push_back(u.middleCols(d.first_node[i], patch.size()));
    geometry::GridParameters<3> grid;
    for (int k = 0; k < 3; ++k) {
      const std::vector<double> breaks = patch.knots(k).breaks();
      for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
        for (int j = 0; j <= patch.degree(k); ++j)
          grid[static_cast<std::size_t>(k)].push_back(breaks[e] +
                                                      (breaks[e + 1] - breaks[e]) * j / patch.degree(k));
    }
    const geometry::NurbsVolume moved(patch.knots(), field.displacement[i], patch.weights());
    largest = isopatch::larger(
        largest, geometry::points_on_grid(moved, grid).colwise().norm().maxCoeff<Eigen::PropagateNaN>());
  }
  const Extremum found = max_displacement(field);
  EXPECT_NEAR(found.value / largest, 1, 1e-13);
  const FieldValues there = evaluate(field, found.patch, found.parameter);
  EXPECT_NEAR(there.displacement.norm() / largest, 1, 1e-12);
  EXPECT_LT((there.place - found.place).norm(), 1e-12 * d.model.size());
}

TEST(ElementSums, DoNotDependOnTheNumberOfThreads) {
  ElasticityProblem p = elbow_of_two_materials();
  const Discretization& d = p.discretization;
  const Eigen::Matrix3Xd u = some_displacement(d);
  p.volume_loads = gravity("weight", {PatchId(0), PatchId(1)}, {1, 2, 3}, p.materials);
  ElasticField field{d.patches, {}, p.materials};
  for (std::size_t i = 0; i < d.patches.size(); ++i)
    field.displacement.push_back(u.middleCols(d.first_node[i], d.patches[i].size()));
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const InternalForces one = internal_forces(d, p.materials, u);
  const Eigen::Matrix3Xd load = load_vector(p);
  const Extremum most = max_displacement(field);
  omp_set_num_threads(3);
  const InternalForces three = internal_forces(d, p.materials, u);
  EXPECT_EQ(one.forces, three.forces);
  EXPECT_EQ(one.energy, three.energy);
  EXPECT_EQ(one.max_von_mises.parameter, three.max_von_mises.parameter);
  EXPECT_EQ(load, load_vector(p));
  EXPECT_EQ(most.parameter, max_displacement(field).parameter);
  omp_set_num_threads(threads);
}

}  // namespace
}  // namespace isopatch::iga
