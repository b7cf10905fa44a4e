#include "iga/problem/bearing_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "iga/problem/internal/face_quadrature.hpp"

namespace isopatch::iga {
namespace {

double pressure_at(const Eigen::Vector3d& normal, const Eigen::Vector3d& gradient) {
  return std::max(0.0, -normal.dot(gradient));
}

struct Resultant {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();  // d force / d gradient
};

Resultant resultant(const std::vector<FacePoint>& points, const Eigen::Vector3d& gradient) {
  Resultant result;
  for (const FacePoint& point : points) {
    const double pressure = pressure_at(point.normal, gradient);
    if (!(pressure > 0)) continue;
    result.force -= point.area * pressure * point.normal;
    result.slope += point.area * point.normal * point.normal.transpose();
  }
  return result;
}

// The step that brings the resultant nearer, in the directions that these pressures can push at all.
Eigen::Vector3d step_towards(const Eigen::Vector3d& rest, const Eigen::Matrix3d& slope) {
  const SymmetricEigen eigen = symmetric_eigen(slope);
  constexpr double least = 1e-9;  // beside the largest: a cylinder's axis by round-off
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < 3; ++k)
    if (eigen.values[k] > least * eigen.values[2])
      step += eigen.vectors.col(k) * (eigen.vectors.col(k).dot(rest) / eigen.values[k]);
  return step;
}

// The force is the gradient of a convex function of g that is quadratic but where points start to be pressed:
// Newton's method ends in a few steps.
Eigen::Vector3d pressure_gradient(const std::string& name, const std::vector<FacePoint>& points,
                                  const Eigen::Vector3d& force) {
  constexpr int most_steps = 50;
  constexpr double enough = 1e-13;
  double area = 0;
  for (const FacePoint& point : points) area += point.area;
  if (!(force.norm() > 0) || !force.allFinite())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}': a bearing load needs a force that is not 0", name));
  Eigen::Vector3d gradient = 3 / area * force;
  double off = 1;
  for (int k = 0; k < most_steps; ++k) {
    const Resultant now = resultant(points, gradient);
    const Eigen::Vector3d rest = force - now.force;
    const double before = off;
    off = rest.norm() / force.norm();
    if (off <= enough || (k > 10 && off < 1e-11 && off >= before)) return gradient;
    if (!(now.slope.trace() > 0)) break;
    gradient += step_towards(rest, now.slope);
  }
  throw Error(ErrorCode::invalid_argument,
              fmt::format("'{}': no pressure on these faces adds up to the force ({:.6g}, {:.6g}, {:.6g}) N; "
                          "{:.3g} of it are left. Pressure acts across faces: on a bore the force must be at "
                          "right angles to its axis, and the faces must hold the side that it presses. Use "
                          "remote or force for the rest",
                          name, force[0], force[1], force[2], off));
}

}  // namespace

SurfaceLoad bearing_load(std::string name, std::vector<geometry::PatchFace> faces,
                         const Eigen::Vector3d& force, const Discretization& discretization,
                         const Region& region) {
  const Eigen::Vector3d gradient =
      pressure_gradient(name, face_points(discretization.patches, faces, region), force);
  return {std::move(name), std::move(faces),
          [gradient](const Eigen::Vector3d&, const Eigen::Vector3d& normal) {
            return Eigen::Vector3d(-pressure_at(normal, gradient) * normal);
          },
          region};
}

}  // namespace isopatch::iga
