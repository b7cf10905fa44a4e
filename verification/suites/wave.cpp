#include "verification/suites/wave.hpp"

#include <cmath>

namespace isopatch::verification {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A function's value, gradient and second derivatives at a place.
struct Jet {
  double value = 1;
  Vector3d slope = Vector3d::Zero();
  Matrix3d curvature = Matrix3d::Zero();
};

Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.value * b.slope + b.value * a.slope,
          a.value * b.curvature + b.value * a.curvature + a.slope * b.slope.transpose() +
              b.slope * a.slope.transpose()};
}

Jet amplitude(const Wave& wave, const Vector3d& x) {
  const double phase = wave.frequency.dot(x) + wave.phase;
  Jet jet{std::sin(phase), std::cos(phase) * wave.frequency,
          -std::sin(phase) * wave.frequency * wave.frequency.transpose()};
  for (const Plane& plane : wave.planes)
    jet = jet * Jet{plane.normal.dot(x) - plane.offset, plane.normal, Matrix3d::Zero()};
  return jet;
}

}  // namespace

Vector3d Wave::displacement(const Vector3d& x) const {
  return linear * x + amplitude(*this, x).value * direction;
}

Matrix3d Wave::gradient(const Vector3d& x) const {
  return linear + direction * amplitude(*this, x).slope.transpose();
}

Vector3d Wave::body_force(const Vector3d& x, const iga::Material& material) const {
  const Matrix3d curvature = amplitude(*this, x).curvature;
  return -(material.lambda + material.mu) * curvature * direction -
         material.mu * curvature.trace() * direction;
}

ExactSolution Wave::exact() const {
  return {[wave = *this](const Vector3d& x) { return wave.displacement(x); },
          [wave = *this](const Vector3d& x) { return wave.gradient(x); }};
}

}  // namespace isopatch::verification
