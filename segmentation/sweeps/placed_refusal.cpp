#include "segmentation/sweeps/internal/placed_refusal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "geometry/brep/require_solid.hpp"

namespace isopatch::segmentation {

Error placed_refusal(const geometry::Brep& solid, const SweepFrame& frame, const DivisionError& error) {
  std::optional<FaceId> beside;
  Eigen::Vector3d place = frame.point(error.place(), 0);
  double least = 1e300;
  for (const FaceId wall : frame.walls) {
    const geometry::DomainBox box = solid.domain(wall);
    const double height = frame.height(solid.point(wall, (box.low + box.high) / 2));
    const Eigen::Vector3d there = frame.point(error.place(), height);
    const double distance = solid.project(wall, there).distance;
    if (distance >= least) continue;
    least = distance;
    beside = wall;
    place = there;
  }
  const auto clean = [](double x) { return std::abs(x) < 5e-7 ? 0.0 : x; };  // no "-0"
  const Eigen::Vector3d mm = 1e3 * place, way = frame.along;
  return Error(ErrorCode::unsupported,
               fmt::format("its outlines as seen along ({:.3g}, {:.3g}, {:.3g}) cannot be divided into "
                           "quadrilaterals near ({:.4g}, {:.4g}, {:.4g}) mm{}",
                           clean(way.x()), clean(way.y()), clean(way.z()), clean(mm.x()), clean(mm.y()),
                           clean(mm.z()), beside ? ", beside " + describe(solid, *beside) : ""));
}

}  // namespace isopatch::segmentation
