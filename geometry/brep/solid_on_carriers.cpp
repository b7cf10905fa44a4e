#include "geometry/brep/solid_on_carriers.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/module.hpp"

namespace isopatch::geometry {
namespace {

void require_number(int number, Eigen::Index count, const std::string& what) {
  if (number < 0 || number >= count)
    throw Error(ErrorCode::invalid_argument, fmt::format("{} {} is none of {}", what, number, count));
}

void require_sound(const CarrierSolid& solid) {
  for (const CarrierSolid::Edge& edge : solid.edges) {
    require_number(edge.start.value, solid.vertices.cols(), "vertex");
    require_number(edge.end.value, solid.vertices.cols(), "vertex");
    const Eigen::Index points = edge.points.cols();
    if (points != 0 &&
        (points < CarrierSolid::points_of_edge || points % (CarrierSolid::points_of_edge - 1) != 1))
      throw Error(ErrorCode::invalid_argument, fmt::format("an edge has {} points", points));
  }
  for (const CarrierSolid::Face& face : solid.faces) {
    if (!face.spline && (face.carrier.kind == SurfaceKind::spline || face.carrier.kind == SurfaceKind::other))
      throw Error(ErrorCode::invalid_argument, fmt::format("face '{}' has no carrier", face.name));
    for (const auto& loop : face.loops)
      for (const EdgeUse& use : loop)
        require_number(use.edge.value, static_cast<Eigen::Index>(solid.edges.size()), "edge");
  }
}

}  // namespace

Brep make_brep(const CarrierSolid& solid, double tolerance) {
  require_sound(solid);
  return Brep(brep_module().on_carriers(solid, tolerance).kernel);
}

}  // namespace isopatch::geometry
