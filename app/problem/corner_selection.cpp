#include "app/problem/corner_selection.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

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

// The patches of a body with faces that do not match others': their corners are nodes of their own.
std::vector<PatchId> patches_apart(const MultiPatch& model, const std::vector<PatchId>& body) {
  std::set<PatchId> apart;
  for (const geometry::NonMatchingInterface& interface : model.non_matching()) {
    apart.insert(interface.first.patch);
    apart.insert(interface.second.patch);
  }
  std::vector<PatchId> result;
  std::copy_if(body.begin(), body.end(), std::back_inserter(result),
               [&](PatchId patch) { return apart.contains(patch); });
  return result;
}

}  // namespace

std::vector<iga::PatchCorner> corners_at(const MultiPatch& model, const Eigen::Vector3d& wanted) {
  const double tolerance = place_tolerance * model.size();
  std::vector<iga::PatchCorner> result;
  for (const std::vector<PatchId>& body : model.bodies()) {
    const auto found = nearest_corner(model, body, wanted);
    if (found.second > tolerance) continue;
    result.push_back(found.first);
    for (const PatchId patch : patches_apart(model, body))
      if (const auto [corner, distance] = nearest_corner(model, {patch}, wanted);
          distance <= tolerance && patch != found.first.patch)
        result.push_back(corner);
  }
  return result;
}

}  // namespace isopatch::app
