#include "geometry/brep/overlay.hpp"

#include "geometry/brep/module.hpp"

namespace isopatch::geometry {

Brep overlay(const Brep& solid, const std::vector<FaceId>& faces, const Eigen::Vector3d& origin,
             const Eigen::Vector3d& direction) {
  for (const FaceId face : faces) (void)solid.face(face);  // checks the id
  return Brep(brep_module().overlay(solid.kernel(), faces, origin, direction).kernel);
}

}  // namespace isopatch::geometry
