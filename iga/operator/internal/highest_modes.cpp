#include "iga/operator/internal/highest_modes.hpp"

#include <cmath>

namespace isopatch::iga {
namespace {

using Eigen::Index;

// The identity without the projection onto polynomials below `degree`, by Legendre polynomials.
Eigen::MatrixXd remainder(int points, int degree) {
  const geometry::QuadratureRule rule = geometry::gauss_legendre(points);
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(points, points);
  const Eigen::ArrayXd x = 2 * rule.nodes.array() - 1;
  Eigen::ArrayXd before = Eigen::ArrayXd::Zero(points);
  Eigen::ArrayXd here = Eigen::ArrayXd::Ones(points);
  for (int k = 0; k < degree; ++k) {
    result -= (2.0 * k + 1) * here.matrix() * (here * rule.weights.array()).matrix().transpose();
    const Eigen::ArrayXd next = ((2 * k + 1) * x * here - k * before) / (k + 1);
    before = here;
    here = next;
  }
  return result;
}

}  // namespace

HighestModes::HighestModes(const GaussPoints& points, const std::array<int, 3>& degrees) : points_(points) {
  for (std::size_t d = 0; d < 3; ++d) remainder_[d] = remainder(points[d], degrees[d]);
}

UnresolvedEnergy HighestModes::energies(const PointStresses& stresses, const Eigen::VectorXd& measures,
                                        const Material& material, PointStresses& buffer) const {
  const double bulk = material.lambda + 2 * material.mu / 3;
  const double per_volumetric = 0.5 / bulk, per_shear = 0.25 / material.mu;
  UnresolvedEnergy result;
  buffer.resize(6, stresses.cols());
  Index stride = 1;
  for (std::size_t d = 0; d < 3; ++d) {
    const Index n = points_[d];
    for (Index layer = 0; layer < stresses.cols(); layer += n * stride)
      for (Index start = layer; start < layer + stride; ++start)
        for (Index i = 0; i < n; ++i) {
          Eigen::Matrix<double, 6, 1> sum = remainder_[d](i, 0) * stresses.col(start);
          for (Index j = 1; j < n; ++j) sum += remainder_[d](i, j) * stresses.col(start + j * stride);
          buffer.col(start + i * stride) = sum;
        }
    for (Index q = 0; q < buffer.cols(); ++q) {
      const auto s = buffer.col(q);
      const double mean = (s[0] + s[1] + s[2]) / 3;
      const double squares =
          (s.template head<3>().array() - mean).square().sum() + 2 * s.template tail<3>().squaredNorm();
      const double volumetric = measures[q] * per_volumetric * mean * mean;
      result.along[d] += volumetric + measures[q] * per_shear * squares;
      result.volumetric += volumetric;
    }
    stride *= n;
  }
  return result;
}

}  // namespace isopatch::iga
