#pragma once

#include <Eigen/Core>
#include <string>

namespace isopatch::iga {

/// Isotropic linear elastic material: stress = 2 mu strain + lambda tr(strain) I.
struct Material {
  double lambda = 0;     ///< first Lame parameter, Pa; above -2/3 mu
  double mu = 0;         ///< shear modulus, Pa; positive
  double density = 0;    ///< kg/m^3; needed by gravity, acceleration and rotation only
  std::string name;      ///< for reports; may be empty
  double expansion = 0;  ///< thermal, linear, 1/K; needed by temperatures only
  double yield = 0;      ///< yield stress, Pa; 0 if it is not known
  bool operator==(const Material&) const = default;
};

/// @param young    E > 0, Pa
/// @param poisson  nu in (-1, 0.5)
/// @throws Error invalid_argument, also for nu = 0.5: an incompressible material has no displacement
/// formulation
Material isotropic(double young, double poisson, double density = 0, std::string name = {});

double young(const Material& material);
double poisson(const Material& material);

/// Stress of a small strain, Pa.
Eigen::Matrix3d stress(const Eigen::Matrix3d& strain, const Material& material);

/// @throws Error invalid_argument if the stiffness is not positive definite or a value is not finite
void validate(const Material& material);

}  // namespace isopatch::iga
