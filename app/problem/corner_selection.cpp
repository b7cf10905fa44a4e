#include "app/problem/corner_selection.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "app/base/engineering_units.hpp"
#include "app/base/place_text.hpp"
#include "app/base/place_tolerance.hpp"

namespace isopatch::app {
namespace {

using geometry::MultiPatch;

Eigen::Vector3d place_of(const MultiPatch& model, const iga::PatchCorner& corner) {
  const geometry::NurbsVolume& patch = model.patch(corner.patch);
  return patch.control_points().col(iga::control_point_of(patch.sizes(), corner));
}

// The corner of a body nearest to a place, and how far away it is.
std::pair<iga::PatchCorner, double> nearest_corner(const MultiPatch& model, const std::vector<PatchId>& body,
                                                   const Eigen::Vector3d& wanted) {
  std::pair<iga::PatchCorner, double> nearest{{}, std::numeric_limits<double>::infinity()};
  for (const PatchId patch : body)
    for (const iga::PatchCorner& corner : iga::corners_of(patch)) {
      const double distance = (place_of(model, corner) - wanted).norm();
      if (distance < nearest.second) nearest = {corner, distance};
    }
  return nearest;
}

}  // namespace

std::vector<iga::PatchCorner> select_corners(const MultiPatch& model,
                                             const std::vector<Eigen::Vector3d>& places, const Place& place) {
  const double tolerance = place_tolerance * model.size();
  std::vector<iga::PatchCorner> result;
  for (const Eigen::Vector3d& wanted : places) {
    std::pair<iga::PatchCorner, double> nearest{{}, std::numeric_limits<double>::infinity()};
    const std::size_t before = result.size();
    for (const std::vector<PatchId>& body : model.bodies()) {
      const auto found = nearest_corner(model, body, wanted);
      if (found.second <= tolerance) result.push_back(found.first);
      if (found.second < nearest.second) nearest = found;
    }
    if (result.size() > before) continue;
    throw error_at(place,
                   fmt::format("points: no corner of a patch lies at {}; the nearest is {} away at {}. Only "
                               "corners of patches can be held: give that one, or cut the patches there",
                               place_with_unit(wanted, model.size()), with_unit(nearest.second, "m"),
                               place_with_unit(place_of(model, nearest.first), model.size())));
  }
  return result;
}

}  // namespace isopatch::app
