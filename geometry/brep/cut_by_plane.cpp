#include "geometry/brep/cut_by_plane.hpp"

#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::geometry {

std::vector<CutPart> cut_by_plane(const Brep& solid, const Eigen::Vector3d& point,
                                  const Eigen::Vector3d& normal) {
  std::vector<CutPart> result;
  double volume = 0;
  for (KernelPart& part : brep_module().cut_by_plane(solid.kernel(), point, normal)) {
    result.push_back({Brep(std::move(part.solid.kernel)), std::move(part.origin)});
    require_solid(result.back().brep);
    volume += result.back().brep.volume();
  }
  if (std::abs(volume - solid.volume()) > 1e-6 * solid.volume())
    throw Error(ErrorCode::unsupported, "the CAD library loses a part of the solid when it is cut");
  return result;
}

}  // namespace isopatch::geometry
