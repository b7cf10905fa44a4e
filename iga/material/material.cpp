#include "iga/material/material.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::iga {

Material isotropic(double young, double poisson, double density, std::string name) {
  if (!(young > 0) || !std::isfinite(young))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("Young's modulus is {} Pa; it must be positive", young));
  if (poisson == 0.5)
    throw Error(ErrorCode::invalid_argument,
                "Poisson's ratio 0.5 means incompressible, which displacements alone cannot describe; use a "
                "value up to "
                "0.4999 with degree 3 or higher");
  if (!(poisson > -1 && poisson < 0.5))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("Poisson's ratio is {}; it must lie between -1 and 0.5", poisson));
  Material material{young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson)),
                    density, std::move(name), 0};
  validate(material);
  return material;
}

double young(const Material& m) {
  return m.mu * (3 * m.lambda + 2 * m.mu) / (m.lambda + m.mu);
}

double poisson(const Material& m) {
  return m.lambda / (2 * (m.lambda + m.mu));
}

Eigen::Matrix3d stress(const Eigen::Matrix3d& strain, const Material& m) {
  return 2 * m.mu * strain + m.lambda * strain.trace() * Eigen::Matrix3d::Identity();
}

void validate(const Material& m) {
  const auto reject = [&](const std::string& what) {
    throw Error(ErrorCode::invalid_argument, fmt::format("material '{}': {}", m.name, what));
  };
  if (!std::isfinite(m.lambda) || !std::isfinite(m.mu) || !std::isfinite(m.density) ||
      !std::isfinite(m.expansion))
    reject("a value is not finite");
  if (!(m.mu > 0)) reject(fmt::format("mu is {} Pa; it must be positive", m.mu));
  if (!(3 * m.lambda + 2 * m.mu > 0))
    reject(fmt::format(
        "lambda is {} Pa; it must be above -2/3 mu, or the material gains energy when compressed", m.lambda));
  if (m.density < 0) reject(fmt::format("density is {} kg/m^3; it cannot be negative", m.density));
}

}  // namespace isopatch::iga
