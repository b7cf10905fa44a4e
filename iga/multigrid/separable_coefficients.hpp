#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/splines/nurbs.hpp"
#include "iga/material/material.hpp"

namespace isopatch::iga {

/// A positive coefficient along one parameter direction, interpolated from samples at the midpoints of equal
/// intervals: its logarithm is linear between them and constant beyond.
struct LineWeight {
  double low = 0;
  double high = 1;
  Eigen::VectorXd logarithms;

  double at(double parameter) const;
};

/// Separable coefficients of the scalar operator that stands for one displacement component: its stiffness to
/// changes along each direction of a patch as a product of functions of one parameter:
///   direction 1: factor[0] s1(x) m2(y) m3(z),  2: factor[1] m1(x) s2(y) m3(z),  3: factor[2] m1 m2 s3
struct SeparableCoefficients {
  std::array<double, 3> factor = {};
  std::array<LineWeight, 3> stiffness;  ///< s
  std::array<LineWeight, 3> mass;       ///< m
};

/// Approximates the true coefficients by separable ones: least squares of the logarithms over a grid of
/// samples.
///
/// @return one for every coordinate component
/// @source Sangalli, Tani, SIAM J. Sci. Comput. 38 (2016), section 5.3 (the idea; least squares of logarithms
/// are ours)
std::array<SeparableCoefficients, 3> separable_coefficients(const geometry::NurbsVolume& patch,
                                                            const Material& material);

}  // namespace isopatch::iga
