#include "geometry/brep/overlay.hpp"

#include <utility>

#include "geometry/brep/module.hpp"

namespace isopatch::geometry {

Overlay overlay(const Brep& solid, const std::vector<FaceId>& faces, const Eigen::Vector3d& origin,
                const Eigen::Vector3d& direction, const Redrawn& redrawn,
                const std::vector<std::array<Eigen::Vector3d, 2>>& lines) {
  for (const FaceId face : faces) (void)solid.face(face);  // checks the id
  KernelOverlay made = brep_module().overlay(solid.kernel(), faces, origin, direction, redrawn, lines);
  return {Brep(std::move(made.sheet)), std::move(made.covered_by)};
}

}  // namespace isopatch::geometry
