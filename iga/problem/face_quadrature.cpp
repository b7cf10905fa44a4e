#include "iga/problem/internal/face_quadrature.hpp"

#include <Eigen/Geometry>

#include "geometry/quadrature.hpp"

namespace isopatch::iga {
namespace {

// Areas are not polynomial and faces are cheap.
constexpr int extra_face_points = 6;

}  // namespace

FaceQuadrature::FaceQuadrature(const geometry::NurbsVolume& patch, geometry::Side side)
    : surface_(geometry::face_surface(patch, side)),
      // Of a right-handed patch, the second direction is the one whose two tangents, in increasing order,
      // turn inwards.
      outward_((geometry::is_high(side) ? 1 : -1) * (geometry::direction(side) == 1 ? -1 : 1)) {
  for (int d = 0; d < 2; ++d)
    tables_[static_cast<std::size_t>(d)] =
        direction_table(surface_.knots(d), geometry::gauss_legendre(surface_.degree(d) + extra_face_points));
}

FacePoint FaceQuadrature::at(double u, double v, double weight) const {
  const geometry::Parameter<2> parameter(u, v);
  const auto jacobian = surface_.jacobian(parameter);
  const Eigen::Vector3d area =
      outward_ * Eigen::Vector3d(jacobian.col(0)).cross(Eigen::Vector3d(jacobian.col(1)));
  const double measure = area.norm();
  if (!(measure > 0)) return {surface_.point(parameter), Eigen::Vector3d::Zero(), 0};
  return {surface_.point(parameter), area / measure, weight * measure};
}

std::vector<FacePoint> face_points(const std::vector<geometry::NurbsVolume>& patches,
                                   const std::vector<geometry::PatchFace>& faces) {
  std::vector<FacePoint> result;
  for (const geometry::PatchFace& face : faces)
    FaceQuadrature(patches.at(static_cast<std::size_t>(face.patch.value)), face.side)
        .for_each([&](const FacePoint& point, const auto&...) { result.push_back(point); });
  return result;
}

}  // namespace isopatch::iga
