#include "iga/multigrid/separable_coefficients.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace isopatch::iga {
namespace {

constexpr int samples = 8;  // per direction

// Logarithms of the stiffness of each component (row) to changes along each direction (column).
Eigen::Matrix3d logarithms_at(const geometry::NurbsVolume& patch, const Material& material,
                              const geometry::Parameter<3>& parameter) {
  const Eigen::Matrix3d jacobian = patch.jacobian(parameter);
  const Eigen::Matrix3d inverse = jacobian.inverse();
  Eigen::Matrix3d result;
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c)
      result(c, d) = std::log(std::abs(jacobian.determinant()) *
                              ((material.lambda + material.mu) * inverse(d, c) * inverse(d, c) +
                               material.mu * inverse.row(d).squaredNorm()));
  return result;
}

// Sums of logarithms with one direction's place fixed.
struct Means {
  Eigen::Matrix3d all = Eigen::Matrix3d::Zero();
  std::array<std::array<Eigen::Matrix3d, samples>, 3> along;  // [direction][place]
};

Means means(const geometry::NurbsVolume& patch, const Material& material) {
  Means result;
  for (auto& direction : result.along) direction.fill(Eigen::Matrix3d::Zero());
  for (int at = 0; at < samples * samples * samples; ++at) {
    const std::array<int, 3> place = {at % samples, at / samples % samples, at / samples / samples};
    const Eigen::Vector3d share(place[0], place[1], place[2]);
    const Eigen::Matrix3d value = logarithms_at(
        patch, material,
        patch.low() + ((share.array() + 0.5) / samples * (patch.high() - patch.low()).array()).matrix());
    result.all += value / (samples * samples * samples);
    for (std::size_t e = 0; e < 3; ++e)
      result.along[e][static_cast<std::size_t>(place[e])] += value / (samples * samples);
  }
  return result;
}

}  // namespace

double LineWeight::at(double parameter) const {
  const auto last = static_cast<double>(logarithms.size() - 1);
  const double place = std::clamp((parameter - low) / (high - low) * (last + 1) - 0.5, 0.0, last);
  const auto below = std::min(static_cast<Eigen::Index>(place), logarithms.size() - 2);
  const double share = place - static_cast<double>(below);
  return std::exp((1 - share) * logarithms[below] + share * logarithms[below + 1]);
}

std::array<SeparableCoefficients, 3> separable_coefficients(const geometry::NurbsVolume& patch,
                                                            const Material& material) {
  const Means mean = means(patch, material);
  std::array<SeparableCoefficients, 3> result;
  for (int c = 0; c < 3; ++c) {
    SeparableCoefficients& of = result[static_cast<std::size_t>(c)];
    for (int d = 0; d < 3; ++d) of.factor[static_cast<std::size_t>(d)] = std::exp(mean.all(c, d));
    for (int e = 0; e < 3; ++e) {
      const auto direction = static_cast<std::size_t>(e);
      LineWeight& stiffness = of.stiffness[direction];
      stiffness = {patch.low()[e], patch.high()[e], Eigen::VectorXd(samples)};
      LineWeight& mass = of.mass[direction];
      mass = stiffness;
      for (int i = 0; i < samples; ++i) {
        // On a full grid the nearest sum of functions of one parameter each is that of the means.
        const Eigen::RowVector3d effect =
            mean.along[direction][static_cast<std::size_t>(i)].row(c) - mean.all.row(c);
        stiffness.logarithms[i] = effect[e];
        mass.logarithms[i] = 0.5 * (effect.sum() - effect[e]);
      }
    }
  }
  return result;
}

}  // namespace isopatch::iga
