// How many conditions tie the patches: counted by isopatch from its global nodes, and here as the rank of
// all coincidences of control points, found by distance and with all their redundancy.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseQR>

#include "geometry/measures.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/dense_systems.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/solved_study.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Conditions on the displacements of all nodes, as rows of a matrix.
struct Conditions {
  Triplets entries;
  int rows = 0;

  void add(std::initializer_list<std::pair<int, Eigen::Vector3d>> nodes) {
    for (const auto& [node, direction] : nodes)
      for (int k = 0; k < 3; ++k)
        if (direction[k] != 0) entries.emplace_back(rows, 3 * node + k, direction[k]);
    ++rows;
  }
  int rank(int nodes) const {
    Eigen::SparseMatrix<double> transposed(3 * nodes, rows);
    Triplets columns;
    for (const auto& entry : entries) columns.emplace_back(entry.col(), entry.row(), entry.value());
    transposed.setFromTriplets(columns.begin(), columns.end());
    Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factors;
    factors.setPivotThreshold(1e-8);
    factors.compute(transposed);
    return static_cast<int>(factors.rank());
  }
};

std::vector<int> nodes_of(const iga::Discretization& d, const geometry::PatchFace& face) {
  const auto p = static_cast<std::size_t>(face.patch.value);
  std::vector<int> nodes = geometry::face_control_points(d.patches[p].sizes(), face.side);
  for (int& node : nodes) node += d.first_node[p];
  return nodes;
}

// Both sides of every interface, control point by control point: those that are closest are one.
void add_coincidences(const iga::Discretization& d, Conditions& conditions) {
  Eigen::Matrix3Xd places(3, d.node_count());
  for (std::size_t p = 0; p < d.patches.size(); ++p)
    places.middleCols(d.first_node[p], d.patches[p].size()) = d.patches[p].control_points();
  for (const geometry::Interface& interface : d.model.interfaces()) {
    const std::vector<int> others = nodes_of(d, interface.second);
    for (const int node : nodes_of(d, interface.first)) {
      const auto distance = [&](int other) { return (places.col(other) - places.col(node)).norm(); };
      int nearest = others.front();
      for (const int other : others)
        if (!(distance(other) >= distance(nearest))) nearest = other;
      for (int k = 0; k < 3; ++k)
        conditions.add({{node, Eigen::Vector3d::Unit(k)}, {nearest, -Eigen::Vector3d::Unit(k)}});
    }
  }
}

// One row for each component that each support prescribes at each of its nodes.
void add_supports(const iga::ElasticityProblem& problem, Conditions& conditions) {
  const iga::Discretization& d = problem.discretization;
  for (const iga::Support& support : problem.supports)
    for (const geometry::PatchFace& face : support.faces) {
      std::vector<Eigen::Vector3d> directions;
      if (const auto* held = std::get_if<iga::PrescribedDisplacement>(&support.condition)) {
        for (int k = 0; k < 3; ++k)
          if (held->value[static_cast<std::size_t>(k)]) directions.push_back(Eigen::Vector3d::Unit(k));
      } else {
        directions = {geometry::outward_normal(d.model.patch(face.patch), face.side, {0.5, 0.5})};
      }
      for (const int node : nodes_of(d, face))
        for (const Eigen::Vector3d& direction : directions) conditions.add({{node, direction}});
    }
}

// Largest singular values of the program's own constraint matrix that are not 0.
int rank_of(const solvers::ConstraintMatrix& matrix) {
  Eigen::SparseMatrix<double> transposed = matrix.transpose();
  transposed.makeCompressed();
  const Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factors(transposed);
  return static_cast<int>(factors.rank());
}

void expect_counts(const std::string& name, const std::string& file, std::vector<std::string> overrides) {
  overrides.emplace_back("coupling.method=lagrange");
  const SolvedStudy tied = solved(file, overrides);
  overrides.back() = "coupling.method=elimination";
  const iga::ProblemSize merged = solved(file, overrides).run.solution.size;
  const iga::ElasticityProblem& problem = tied.run.built.problem;
  const iga::ProblemSize& size = tied.run.solution.size;
  const int nodes = problem.discretization.node_count();
  const auto claim = [&](const std::string& what, const std::string& source, double reference,
                         std::int64_t value) {
    expect(Claim{name + ": " + what, "", ReferenceKind::other_method, source, reference,
                 static_cast<double>(value), 0, tied.named});
  };
  Conditions conditions;
  add_coincidences(problem.discretization, conditions);
  claim("multipliers before supports", "rank of all coincidences, by sparse QR", conditions.rank(nodes),
        size.multipliers);
  add_supports(problem, conditions);
  claim("free unknowns of elimination", "3 nodes less the rank of coincidences and supports",
        3.0 * nodes - conditions.rank(nodes), merged.dofs_free);
  const solvers::ConstraintMatrix matrix = system_of(problem, iga::Coupling::lagrange).constraints;
  claim("multipliers after supports", "rank of their own matrix, by sparse QR", rank_of(matrix),
        size.multipliers_free);
  claim("free unknowns with multipliers", "those of elimination, and twice the multipliers",
        static_cast<double>(merged.dofs_free + 2 * size.multipliers_free), size.dofs_free);
}

TEST(Coupling, CountsOfConstraints) {
  for (const ModelCase& model : model_cases()) {
    std::vector<std::string> overrides = pulled_overrides(model);
    overrides.insert(overrides.end(), {"discretization.degree=1", "discretization.refine=0"});
    expect_counts(model.name + " as it is", "verification/studies/pulled.toml", overrides);
  }
  expect_counts("octant of a sphere on symmetry planes", "verification/studies/hollow_sphere.toml",
                {"discretization.refine=0", "model.radial_patches=2"});
  expect_counts("sector of 140 degrees on oblique planes", "examples/thick_cylinder/study.toml",
                {"discretization.degree=2", "discretization.refine=0", "model.angle=140 deg"});
}

TEST(Coupling, CountsOfConstraintsOfTerrific) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  expect_counts("TERRIFIC, p = 2", "examples/terrific/study.toml", {"discretization.degree=2"});
}

TEST(Coupling, CountsOfConstraintsOfTheChairStand) {
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  expect_counts("chair stand", "examples/chair_stand/study.toml", {});
}

}  // namespace
}  // namespace isopatch::verification
