#include "iga/problem/internal/face_quadrature.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/quadrature.hpp"
#include "geometry/splines/basis.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::iga {
namespace {

// Areas are not polynomial and faces are cheap.
constexpr int extra_face_points = 6;

}  // namespace

FaceQuadrature::FaceQuadrature(const geometry::NurbsVolume& patch, geometry::Side side, const Region& region)
    : surface_(geometry::face_surface(patch, side)),
      // Of a right-handed patch, the second direction is the one whose two tangents, in increasing order,
      // turn inwards.
      outward_((geometry::is_high(side) ? 1 : -1) * (geometry::direction(side) == 1 ? -1 : 1)) {
  for (int d = 0; d < 2; ++d)
    tables_[static_cast<std::size_t>(d)] =
        direction_table(surface_.knots(d), geometry::gauss_legendre(surface_.degree(d) + extra_face_points));
  if (region.is_everywhere()) return;
  const int points = std::max(surface_.degree(0), surface_.degree(1)) + extra_face_points;
  const double slack = place_slack(patch);
  for (const geometry::NurbsSurface& element : geometry::bezier_pieces(surface_))
    cuts_.push_back(cut_rule(element, region, points, slack));
}

DirectionTable::Element FaceQuadrature::single(int direction, double parameter) const {
  const geometry::BasisValues at = geometry::basis(surface_.knots(direction), parameter, 1);
  return {at.first, at.values.row(0), at.values.row(1), Eigen::VectorXd::Constant(1, parameter),
          Eigen::VectorXd::Ones(1)};
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

double place_slack(const geometry::NurbsVolume& patch) {
  constexpr double share = 1e-7;
  const Eigen::Matrix3Xd& controls = patch.control_points();
  return share * (controls.rowwise().maxCoeff() - controls.rowwise().minCoeff()).norm();
}

std::vector<FacePoint> face_points(const std::vector<geometry::NurbsVolume>& patches,
                                   const std::vector<geometry::PatchFace>& faces, const Region& region) {
  std::vector<FacePoint> result;
  for (const geometry::PatchFace& face : faces)
    FaceQuadrature(patches.at(static_cast<std::size_t>(face.patch.value)), face.side, region)
        .for_each([&](const FacePoint& point, const auto&...) { result.push_back(point); });
  return result;
}

}  // namespace isopatch::iga
