#include "geometry/attach.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

std::string label(const PatchFace& face) {
  return fmt::format("{}:{}", face.patch.value, name(face.side));
}

void check(const PatchSet& set, const std::vector<PatchFace>& faces) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const PatchFace& face = faces[i];
    if (face.patch.value < 0 || static_cast<std::size_t>(face.patch.value) >= set.patches.size())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("nothing can be attached to the face {}: the model has patches 0 to {}",
                              label(face), static_cast<int>(set.patches.size()) - 1));
    if (std::find(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(i), face) !=
        faces.begin() + static_cast<std::ptrdiff_t>(i))
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("the face {} is given twice: one patch can be attached to it", label(face)));
  }
}

NurbsVolume between(const NurbsSurface& surface, const Eigen::Affine3d& map, const PatchFace& face) {
  const Eigen::Matrix3Xd moved = map * surface.control_points();
  const double size =
      (surface.control_points().rowwise().maxCoeff() - surface.control_points().rowwise().minCoeff()).norm();
  if (!((moved - surface.control_points()).colwise().norm().maxCoeff() > 1e-9 * size))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("a patch attached to the face {} would have no thickness: move or scale it",
                            label(face)));
  return ruled(surface, NurbsSurface(surface.knots(), moved, surface.weights()));
}

}  // namespace

PatchSet attached(PatchSet set, const std::vector<PatchFace>& faces, const Eigen::Affine3d& map,
                  const std::string& name) {
  check(set, faces);
  Boundary images{name, {}};
  for (const PatchFace& face : faces) {
    const NurbsSurface surface =
        face_surface(set.patches[static_cast<std::size_t>(face.patch.value)], face.side);
    images.faces.push_back({PatchId(static_cast<int>(set.patches.size())), Side::back});
    set.patches.push_back(between(surface, map, face));
    for (Boundary& boundary : set.boundaries) std::erase(boundary.faces, face);
  }
  std::erase_if(set.boundaries, [](const Boundary& boundary) { return boundary.faces.empty(); });
  if (name.empty()) return set;
  const auto same = std::find_if(set.boundaries.begin(), set.boundaries.end(),
                                 [&](const Boundary& boundary) { return boundary.name == name; });
  if (same == set.boundaries.end())
    set.boundaries.push_back(std::move(images));
  else
    same->faces.insert(same->faces.end(), images.faces.begin(), images.faces.end());
  return set;
}

}  // namespace isopatch::geometry
