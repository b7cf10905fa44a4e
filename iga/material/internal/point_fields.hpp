#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cstddef>

#include "iga/internal/tensor_contraction.hpp"
#include "iga/material/material.hpp"

namespace isopatch::iga {

/// Value and first derivatives of a rational map, from the homogeneous ones.
struct RationalPoint {
  Eigen::Vector3d value;
  Eigen::Matrix3d derivatives;  ///< one column per direction
};

/// @param first  0: of the components 0 .. 2, the geometry; 4: of 4 .. 6, the displacement; component 3 is
/// the weight
template <int C>
RationalPoint rational_point(const TensorBuffers<C>& buffers, std::size_t point, int first = 0) {
  const auto& [value, du, dv, dw] = buffers.at;
  const double inverse = 1 / value[point][3];
  RationalPoint result;
  result.value = inverse * value[point].template segment<3>(first).matrix();
  int column = 0;
  for (const auto* d : {&du, &dv, &dw})
    result.derivatives.col(column++) =
        inverse * ((*d)[point].template segment<3>(first).matrix() - (*d)[point][3] * result.value);
  return result;
}

/// Derivatives of a displacement at a point, columns with a 0 behind each.
struct PointDerivatives {
  std::array<FieldLanes<4>, 3> along;     ///< of the parameters, one per direction
  std::array<FieldLanes<4>, 3> gradient;  ///< along x, y and z
};

/// Of a displacement's numerators and the weight.
/// @param inverse      of the derivatives of the map
/// @param denominator  one over the weight
inline PointDerivatives point_derivatives(const TensorBuffers<4>& buffers, std::size_t point,
                                          const Eigen::Matrix3d& inverse, double denominator) {
  const FieldLanes<4> value = denominator * buffers.at[0][point];
  PointDerivatives result;
  result.gradient.fill(FieldLanes<4>::Zero());
  for (std::size_t k = 0; k < 3; ++k) {
    const FieldLanes<4>& of_numerator = buffers.at[k + 1][point];
    result.along[k] = denominator * (of_numerator - of_numerator[3] * value);
    for (std::size_t i = 0; i < 3; ++i)
      result.gradient[i] +=
          inverse(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) * result.along[k];
  }
  return result;
}

/// Stress (Pa) of a displacement gradient, of which a thermal strain along all axes causes none.
inline Eigen::Matrix3d stress_of_gradient(const Eigen::Matrix3d& gradient, const Material& material,
                                          double thermal) {
  Eigen::Matrix3d result = material.mu * (gradient + gradient.transpose());
  result.diagonal().array() +=
      material.lambda * gradient.trace() - (3 * material.lambda + 2 * material.mu) * thermal;
  return result;
}

/// Stress (Pa) of a displacement gradient. Von Mises stresses are the same with a thermal strain.
inline Eigen::Matrix3d stress_of_gradient(const Eigen::Matrix3d& gradient, const Material& material) {
  Eigen::Matrix3d result = material.mu * (gradient + gradient.transpose());
  result.diagonal().array() += material.lambda * gradient.trace();
  return result;
}

}  // namespace isopatch::iga
