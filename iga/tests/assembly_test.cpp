#include "iga/assembly/assembly.hpp"
#include "geometry/base/dense_matrices.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/LU>
#include <numeric>

#include "geometry/models/cylinder.hpp"
#include "geometry/quadrature.hpp"
#include "iga/tests/plain_stiffness.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;

RowNumbering own_rows(const Discretization& d) {
  RowNumbering numbering{std::vector<int>(static_cast<std::size_t>(d.node_count())), d.node_count()};
  std::iota(numbering.row_of_node.begin(), numbering.row_of_node.end(), 0);
  return numbering;
}

// The plain way, sharing nothing with the assembler but the spline itself: strains of every function at every
// point by the volume's own derivatives, in Voigt's notation.
Eigen::MatrixXd reference_stiffness(const NurbsVolume& patch, const Material& material,
                                    const GaussPoints& points) {
  const int n = patch.size();
  Eigen::Matrix<double, 6, 6> elasticity = Eigen::Matrix<double, 6, 6>::Zero();
  elasticity.topLeftCorner<3, 3>().setConstant(material.lambda);
  elasticity.diagonal().array() += material.mu;
  elasticity.diagonal().head<3>().array() += material.mu;
  std::vector<NurbsVolume> functions;  // each basis function as the x coordinate of a map
  for (int a = 0; a < n; ++a) {
    Eigen::Matrix3Xd unit = Eigen::Matrix3Xd::Zero(3, n);
    unit(0, a) = 1;
    functions.emplace_back(patch.knots(), unit, patch.weights());
  }
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  std::array<std::vector<double>, 3> nodes, weights;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto rule = geometry::gauss_legendre(points[d]);
    const auto breaks = patch.knots()[d].breaks();
    for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
      for (Eigen::Index q = 0; q < rule.nodes.size(); ++q) {
        nodes[d].push_back(breaks[e] + (breaks[e + 1] - breaks[e]) * rule.nodes[q]);
        weights[d].push_back((breaks[e + 1] - breaks[e]) * rule.weights[q]);
      }
  }
  for (std::size_t k = 0; k < nodes[2].size(); ++k)
    for (std::size_t j = 0; j < nodes[1].size(); ++j)
      for (std::size_t i = 0; i < nodes[0].size(); ++i) {
        const geometry::Parameter<3> at(nodes[0][i], nodes[1][j], nodes[2][k]);
        const Eigen::Matrix3d jacobian = patch.jacobian(at);
        Eigen::MatrixXd strains = Eigen::MatrixXd::Zero(6, 3 * n);
        for (int a = 0; a < n; ++a) {
          const Eigen::RowVector3d g =
              functions[static_cast<std::size_t>(a)].jacobian(at).row(0) * jacobian.inverse();
          strains.middleCols<3>(3 * a) << g[0], 0, 0, 0, g[1], 0, 0, 0, g[2], g[1], g[0], 0, 0, g[2], g[1],
              g[2], 0, g[0];
        }
        stiffness += weights[0][i] * weights[1][j] * weights[2][k] * jacobian.determinant() *
                     strains.transpose() * elasticity * strains;
      }
  return stiffness;
}

TEST(Assembly, EqualsThePlainStrainDisplacementProductOnARationalPatch) {
  const geometry::MultiPatch model = geometry::connect(geometry::cylinder_model({}));
  const Discretization d = discretize(model, {.degree = {2, 3, 1}, .elements_per_direction = {2, 1, 1}});
  const Material material = isotropic(3, 0.3);
  const Eigen::MatrixXd fast = dense(assemble_stiffness(d, {material}, own_rows(d)));
  const Eigen::MatrixXd slow = reference_stiffness(d.patches[0], material, d.gauss_points[0]);
  EXPECT_LT((fast - slow).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
            1e-13 * slow.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

TEST(Assembly, LeavesExactlySixRigidMotionsToAFreePatch) {
  const geometry::MultiPatch model = geometry::connect(geometry::box_model({.curvature = 0.3}));
  const Discretization d = discretize(model);
  const Eigen::MatrixXd k = dense(assemble_stiffness(d, {isotropic(1, 0.25)}, own_rows(d)));
  const Eigen::VectorXd values = symmetric_eigenvalues(k);
  EXPECT_LT(values.head<6>().cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
            1e-13 * values.maxCoeff<Eigen::PropagateNaN>());
  EXPECT_GT(values[6], 1e-4 * values.maxCoeff<Eigen::PropagateNaN>());
}

TEST(Assembly, GivesTheSameBitsForAnyNumberOfThreads) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.patches = {2, 2, 1}, .distortion = 0.2}));
  const Discretization d = discretize(model, {.refine = 2});
  const std::vector<Material> materials(4, isotropic(1, 0.3));
  const int usual = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = assemble_stiffness(d, materials, own_rows(d));
  for (const auto& [threads, dynamic] : {std::pair{2, 0}, std::pair{5, 0}, std::pair{8, 1}}) {
    omp_set_num_threads(threads);
    omp_set_dynamic(dynamic);  // lets the runtime give fewer threads than asked for
    EXPECT_EQ(assemble_stiffness(d, materials, own_rows(d)).values, one.values) << threads;
  }
  omp_set_dynamic(0);
  omp_set_num_threads(usual);
}

TEST(Assembly, SharedRowsSumWhatTheirNodesHave) {
  const geometry::MultiPatch model = geometry::connect(
      geometry::box_model({.patches = {2, 1, 1}, .distortion = 0.2, .orientation_seed = 3}));
  const Discretization d = discretize(model);
  const Material material = isotropic(1, 0.3);
  const std::vector<Material> materials(2, material);
  const Eigen::MatrixXd apart = dense(assemble_stiffness(d, materials, own_rows(d)));
  RowNumbering pairs{std::vector<int>(16),
                     8};  // every node shares a row with another one, whatever that means
  for (int node = 0; node < 16; ++node) pairs.row_of_node[static_cast<std::size_t>(node)] = node / 2;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(24, 24);
  for (int a = 0; a < 16; ++a)
    for (int b = 0; b < 16; ++b) sum.block<3, 3>(a / 2 * 3, b / 2 * 3) += apart.block<3, 3>(3 * a, 3 * b);
  EXPECT_LT((dense(assemble_stiffness(d, materials, pairs)) - sum).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
            1e-14 * sum.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

}  // namespace
}  // namespace isopatch::iga
