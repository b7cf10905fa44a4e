#include "geometry/patch_connections.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "geometry/base/error.hpp"
#include "geometry/measures.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

void require_face(const PatchFace& face, std::size_t patches) {
  const int side = static_cast<int>(face.side);
  if (face.patch.value < 0 || static_cast<std::size_t>(face.patch.value) >= patches || side < 0 || side > 5)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("there is no face {} of patch {}; there are {} patches with sides 0 to 5", side,
                            face.patch.value, patches));
}

PatchFace as_given(const PatchConnections& connections, PatchFace face) {
  if (connections.reversed[static_cast<std::size_t>(face.patch.value)] && direction(face.side) == 0)
    face.side = opposite(face.side);
  return face;
}

/// The patches as they were before `connect` turned left-handed ones around.
PatchSet as_given(const std::vector<NurbsVolume>& patches, const PatchConnections& connections) {
  PatchSet set{{}, connections.boundaries, {}};
  for (std::size_t p = 0; p < patches.size(); ++p)
    set.patches.push_back(connections.reversed[p] ? reversed(patches[p], 0) : patches[p]);
  for (Boundary& boundary : set.boundaries)
    for (PatchFace& face : boundary.faces) face = as_given(connections, face);
  const auto reversed_patch = [&](PatchFace face) {
    return connections.reversed[static_cast<std::size_t>(face.patch.value)];
  };
  for (const Interface& i : connections.interfaces)
    set.interfaces.push_back(
        turned_around({i.first, i.second, i.orientation}, reversed_patch(i.first), reversed_patch(i.second)));
  return set;
}

/// In absolute terms those of the model: control points of refined patches span a smaller box. Gaps that were
/// accepted may be seen to be a little larger, as refined patches are compared at more points.
Tolerance tolerance_for(const std::vector<NurbsVolume>& patches, const PatchConnections& connections) {
  constexpr double margin = 1.5;
  constexpr double most = 0.009;  // `connect` takes no more than 1e-2
  double gap = 0;
  for (const Interface& interface : connections.interfaces) gap = std::max(gap, interface.gap);
  Eigen::AlignedBox3d all;
  for (const NurbsVolume& patch : patches) all.extend(box(patch));
  const double size = all.diagonal().norm();
  Tolerance tolerance = connections.tolerance;
  const double same_point = std::max(tolerance.same_point * connections.size, margin * gap) / size;
  const double near_miss = tolerance.near_miss * connections.size / size;
  tolerance.same_point = std::min(same_point, most);
  tolerance.near_miss = std::min(std::max(near_miss, 2 * tolerance.same_point), 0.09);
  return tolerance;
}

bool is_same(const Interface& x, const Interface& y) {
  return x.first == y.first && x.second == y.second && x.orientation == y.orientation;
}

bool are_same(const std::vector<Interface>& a, const std::vector<Interface>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same);
}

/// Faces agree point by point and are yet kept apart if patches have functions of their own on both sides.
MultiPatch as_kept(const MultiPatch& model, const PatchConnections& connections) {
  if (!connections.tolerance.keep_non_matching) return model;
  std::vector<bool> apart;
  for (const Interface& found : model.interfaces())
    apart.push_back(std::none_of(connections.interfaces.begin(), connections.interfaces.end(),
                                 [&](const Interface& kept) { return is_same(found, kept); }));
  return model.with_apart(apart);
}

}  // namespace

PatchConnections connections_of(const MultiPatch& model) {
  PatchConnections result{model.interfaces(), model.boundaries(), {}, model.tolerance(), model.size()};
  for (int p = 0; p < model.patch_count(); ++p) result.reversed.push_back(model.was_reversed(PatchId(p)));
  return result;
}

void validate(const PatchConnections& connections, std::size_t patch_count) {
  if (connections.reversed.size() != patch_count)
    throw Error(ErrorCode::invalid_argument, fmt::format("connections of {} patches are given for {} patches",
                                                         connections.reversed.size(), patch_count));
  if (!(connections.size > 0))
    throw Error(ErrorCode::invalid_argument, fmt::format("the model's size is {}", connections.size));
  std::set<PatchFace> joined;
  for (const Interface& interface : connections.interfaces)
    for (const PatchFace& face : {interface.first, interface.second}) {
      require_face(face, patch_count);
      if (!joined.insert(face).second)
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("face {}:{} is joined twice", face.patch.value, name(face.side)));
    }
  for (const Boundary& boundary : connections.boundaries)
    for (const PatchFace& face : boundary.faces) require_face(face, patch_count);
}

MultiPatch connected(const std::vector<NurbsVolume>& patches, const PatchConnections& connections) {
  validate(connections, patches.size());
  constexpr const char* other = "the patches do not meet as their connections say";
  try {
    MultiPatch model =
        as_kept(connect(as_given(patches, connections), tolerance_for(patches, connections)), connections);
    if (connections_of(model).reversed != connections.reversed ||
        !are_same(model.interfaces(), connections.interfaces))
      throw Error(ErrorCode::invalid_argument, other);
    return model;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::not_conforming) throw;
    throw Error(ErrorCode::invalid_argument, fmt::format("{}: {}", other, error.what()));
  }
}

}  // namespace isopatch::geometry
