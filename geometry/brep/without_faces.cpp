#include "geometry/brep/without_faces.hpp"

#include <fmt/format.h>

#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::geometry {

Brep without_faces(const Brep& solid, const std::vector<FaceId>& faces) {
  for (const FaceId face : faces) (void)solid.face(face);  // checks the id
  Brep result(brep_module().without_faces(solid.kernel(), faces).kernel);
  // The library returns the solid as it was, or with other faces in their place, where it cannot do it.
  if (result.faces().size() != solid.faces().size() - faces.size())
    throw Error(ErrorCode::unsupported,
                fmt::format("the faces around {}{} do not meet without {}", describe(solid, faces.front()),
                            faces.size() == 1 ? "" : fmt::format(" and {} others", faces.size() - 1),
                            faces.size() == 1 ? "it" : "them"));
  require_solid(result);
  return result;
}

}  // namespace isopatch::geometry
