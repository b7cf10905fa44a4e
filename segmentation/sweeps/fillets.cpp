#include "segmentation/sweeps/internal/fillets.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::SurfaceKind;

/// Sine of the angle that counts as none.
constexpr double level_sine = 1e-7;

/// Whether the normal turns by a right angle across a face, one way or the other, as from a floor to a wall.
bool turns_by_a_quarter(const Brep& solid, FaceId face) {
  constexpr double cosine_of_89_degrees = 0.0175;
  const geometry::DomainBox domain = solid.domain(face);
  const Eigen::Vector2d middle = (domain.low + domain.high) / 2;
  const auto cosine = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::abs(solid.outward_normal(face, a).dot(solid.outward_normal(face, b)));
  };
  return cosine({domain.low.x(), middle.y()}, {domain.high.x(), middle.y()}) < cosine_of_89_degrees ||
         cosine({middle.x(), domain.low.y()}, {middle.x(), domain.high.y()}) < cosine_of_89_degrees;
}

std::optional<Fillet> fillet_at(const Brep& solid, FaceId face, const Eigen::Vector3d& along) {
  const auto carrier = solid.carrier(face);
  if (!carrier) return std::nullopt;
  const bool torus = carrier->kind == SurfaceKind::torus && carrier->axis.cross(along).norm() < level_sine;
  const bool cylinder =
      carrier->kind == SurfaceKind::cylinder && std::abs(carrier->axis.dot(along)) < level_sine;
  if ((!torus && !cylinder) || !turns_by_a_quarter(solid, face)) return std::nullopt;
  const geometry::DomainBox domain = solid.domain(face);
  const Eigen::Vector2d uv = (domain.low + domain.high) / 2;
  const Eigen::Vector3d middle = solid.point(face, uv);
  Eigen::Vector3d out = middle - carrier->origin;
  Eigen::Vector3d centre = carrier->origin;
  if (torus)
    centre += carrier->radius * (out - out.dot(along) * along).normalized();
  else
    centre += out.dot(carrier->axis) * carrier->axis;
  const Eigen::Vector3d to_centre = centre - middle;
  const double towards = solid.outward_normal(face, uv).dot(to_centre);
  if (std::abs(towards) < 0.9 * to_centre.norm()) return std::nullopt;
  return Fillet{face, torus ? carrier->second_radius : carrier->radius, centre, to_centre.dot(along) > 0,
                towards < 0};
}

}  // namespace

std::optional<std::vector<Fillet>> fillets(const Brep& solid, const Eigen::Vector3d& along) {
  std::vector<Fillet> result;
  for (const FaceId face : neither_floor_nor_wall(solid, along)) {
    const std::optional<Fillet> fillet = fillet_at(solid, face, along);
    if (!fillet) return std::nullopt;
    result.push_back(*fillet);
  }
  if (result.empty()) return std::nullopt;
  return result;
}

}  // namespace isopatch::segmentation
