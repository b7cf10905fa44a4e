#include "verification/suites/classic_fields.hpp"

#include <cmath>
#include <complex>

namespace isopatch::verification {
namespace {

using Complex = std::complex<double>;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// 2 mu (u_x + i u_y) = kappa phi - z conj(phi') - conj(psi).
struct Kirsch {
  double tension;
  double mu;
  double kappa;  // 3 - 4 nu in plane strain

  Vector3d displacement(const Vector3d& x) const {
    const Complex z(x[0], x[1]);
    const Complex phi = tension / 4 * (z + 2.0 / z);
    const Complex slope = tension / 4 * (1.0 - 2.0 / (z * z));
    const Complex psi = -tension / 2 * (z + 1.0 / z - 1.0 / (z * z * z));
    const Complex u = (kappa * phi - z * std::conj(slope) - std::conj(psi)) / (2 * mu);
    return {u.real(), u.imag(), 0};
  }
  Matrix3d gradient(const Vector3d& x) const {
    const Complex z(x[0], x[1]);
    const Complex slope = tension / 4 * (1.0 - 2.0 / (z * z));
    const Complex curvature = tension / (z * z * z);
    const Complex psi_slope = -tension / 2 * (1.0 - 1.0 / (z * z) + 3.0 / (z * z * z * z));
    // Derivatives along z and along its conjugate.
    const Complex along = (kappa * slope - std::conj(slope)) / (2 * mu);
    const Complex against = (-z * std::conj(curvature) - std::conj(psi_slope)) / (2 * mu);
    const Complex by_x = along + against;
    const Complex by_y = Complex(0, 1) * (along - against);
    Matrix3d result = Matrix3d::Zero();
    result.topLeftCorner<2, 2>() << by_x.real(), by_y.real(), by_x.imag(), by_y.imag();
    return result;
  }
};

// u = a(x) x + b(x) z e_z with a = a3 / r^3 + a5 / r^5 + z^2 (c5 / r^5 + c7 / r^7) + a0 and
// b = b3 / r^3 + b5 / r^5 + b0: Goodier's u_r and u_t with sin 2t e_t = 2 cos t (cos t e_r - e_z).
struct Goodier {
  double a0, a3, a5, c5, c7, b0, b3, b5;

  Goodier(const iga::Material& material, double tension) {
    const double nu = iga::poisson(material);
    const double young = iga::young(material);
    const double q = tension / (8 * material.mu * (7 - 5 * nu));
    const double c = 5 * q * (1 - 2 * nu);
    a0 = -nu * tension / young;
    a3 = q * (13 - 10 * nu) - (5 - 4 * nu) * c / (1 - 2 * nu);
    a5 = 6 * q;
    c5 = 6 * c / (1 - 2 * nu);
    c7 = -30 * q;
    b0 = (1 + nu) * tension / young;
    b3 = 4 * c;
    b5 = 12 * q;
  }

  Vector3d displacement(const Vector3d& x) const {
    const double r = x.norm();
    const double z2 = x[2] * x[2];
    const double a = a0 + a3 * std::pow(r, -3) + (a5 + z2 * c5) * std::pow(r, -5) + z2 * c7 * std::pow(r, -7);
    const double b = b0 + b3 * std::pow(r, -3) + b5 * std::pow(r, -5);
    return a * x + b * x[2] * Vector3d::UnitZ();
  }
  Matrix3d gradient(const Vector3d& x) const {
    const double r = x.norm();
    const double z = x[2];
    const double a =
        a0 + a3 * std::pow(r, -3) + (a5 + z * z * c5) * std::pow(r, -5) + z * z * c7 * std::pow(r, -7);
    const double b = b0 + b3 * std::pow(r, -3) + b5 * std::pow(r, -5);
    // The gradient of r^-n is -n r^-(n+2) x.
    const Vector3d a_slope = (-3 * a3 * std::pow(r, -5) - 5 * (a5 + z * z * c5) * std::pow(r, -7) -
                              7 * z * z * c7 * std::pow(r, -9)) *
                                 x +
                             2 * z * (c5 * std::pow(r, -5) + c7 * std::pow(r, -7)) * Vector3d::UnitZ();
    const Vector3d b_slope = (-3 * b3 * std::pow(r, -5) - 5 * b5 * std::pow(r, -7)) * x;
    return a * Matrix3d::Identity() + x * a_slope.transpose() +
           Vector3d::UnitZ() * (b * Vector3d::UnitZ() + z * b_slope).transpose();
  }
};

// u = factor ((1 - 2 nu) + outer^2 / r^2) (x, y, 0).
struct Lame {
  double nu, factor, outer_squared;

  Vector3d displacement(const Vector3d& x) const {
    const Vector3d r(x[0], x[1], 0);
    return factor * ((1 - 2 * nu) + outer_squared / r.squaredNorm()) * r;
  }
  Matrix3d gradient(const Vector3d& x) const {
    const Vector3d r(x[0], x[1], 0);
    const Matrix3d plane = Vector3d(1, 1, 0).asDiagonal();
    const double squared = r.squaredNorm();
    return factor * (((1 - 2 * nu) + outer_squared / squared) * plane -
                     2 * outer_squared / (squared * squared) * r * r.transpose());
  }
};

template <class Field>
ExactSolution exact(const Field& field) {
  return {[=](const Vector3d& x) { return field.displacement(x); },
          [=](const Vector3d& x) { return field.gradient(x); }};
}

}  // namespace

ExactSolution pressed_cylinder(const iga::Material& material, double pressure, double inner, double outer) {
  const double nu = iga::poisson(material);
  const double factor =
      (1 + nu) / iga::young(material) * pressure * inner * inner / (outer * outer - inner * inner);
  return exact(Lame{nu, factor, outer * outer});
}

ExactSolution pulled_plate_with_hole(const iga::Material& material, double tension) {
  return exact(Kirsch{tension, material.mu, 3 - 4 * iga::poisson(material)});
}

ExactSolution pulled_body_with_cavity(const iga::Material& material, double tension) {
  return exact(Goodier(material, tension));
}

}  // namespace isopatch::verification
