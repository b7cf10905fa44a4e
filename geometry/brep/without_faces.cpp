#include "geometry/brep/without_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::geometry {
namespace {

/// Nothing where the library returns the solid as it was, or with other faces in their place.
std::optional<Brep> without_all_at_once(const Brep& solid, const std::vector<FaceId>& faces) {
  try {
    Brep result(brep_module().without_faces(solid.kernel(), faces).kernel);
    if (result.faces().size() + faces.size() == solid.faces().size()) return result;
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
  }
  return std::nullopt;
}

/// The first of some faces with those that it hangs together with.
std::vector<FaceId> first_group(const Brep& solid, const std::vector<FaceId>& faces) {
  std::set<FaceId> left(faces.begin(), faces.end());
  std::vector<FaceId> result = {faces.front()};
  left.erase(faces.front());
  for (std::size_t i = 0; i < result.size(); ++i)
    for (const auto& loop : solid.face(result[i]).loops)
      for (const EdgeUse& use : loop)
        for (const FaceId other : solid.edge(use.edge).faces)
          if (left.erase(other) > 0) result.push_back(other);
  return result;
}

/// The library refuses some faces together that it takes off one after the other: holes all around a ring.
std::optional<Brep> without_group_by_group(Brep solid, std::vector<FaceId> faces) {
  while (!faces.empty()) {
    const std::vector<FaceId> group = first_group(solid, faces);
    std::optional<Brep> next = without_all_at_once(solid, group);
    if (!next) return std::nullopt;
    solid = *std::move(next);
    std::vector<FaceId> left;
    for (const FaceId face : faces) {
      if (std::find(group.begin(), group.end(), face) != group.end()) continue;
      const auto before = std::count_if(group.begin(), group.end(), [&](FaceId gone) { return gone < face; });
      left.emplace_back(face.value - static_cast<int>(before));
    }
    faces = std::move(left);
  }
  return solid;
}

}  // namespace

Brep without_faces(const Brep& solid, const std::vector<FaceId>& faces) {
  for (const FaceId face : faces) (void)solid.face(face);  // checks the id
  std::optional<Brep> result = without_all_at_once(solid, faces);
  if (!result && first_group(solid, faces).size() < faces.size())
    result = without_group_by_group(solid, faces);
  if (!result)
    throw Error(ErrorCode::unsupported,
                fmt::format("the faces around {}{} do not meet without {}", describe(solid, faces.front()),
                            faces.size() == 1 ? "" : fmt::format(" and {} others", faces.size() - 1),
                            faces.size() == 1 ? "it" : "them"));
  require_solid(*result);
  return *std::move(result);
}

}  // namespace isopatch::geometry
