#include "segmentation/parameterization/brep_solid.hpp"

#include <fmt/format.h>

#include "geometry/brep/solid_error.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::BrepEdge;
using geometry::BrepFace;

SolidFace solid_face(const Brep& brep, FaceId id, const std::string& solid) {
  const BrepFace& face = brep.face(id);
  SolidFace result;
  result.name = face.name.empty() ? fmt::format("face {}", id.value) : face.name;
  if (face.colour) result.colour = geometry::hex_text(*face.colour);
  if (face.loops.size() != 1)
    throw geometry::SolidError(
        ErrorCode::unsupported,
        fmt::format("solid '{}', face '{}' has {} outlines; each face of a hexahedron has one. Cut the solid "
                    "through the hole first",
                    solid, result.name, face.loops.size()),
        {.faces = {{id.value, solid, fmt::format("{} outlines", face.loops.size())}}});
  for (const geometry::EdgeUse& use : face.loops.front()) {
    const BrepEdge& edge = brep.edge(use.edge);
    result.corners.push_back((use.reversed ? edge.end : edge.start).value);
    result.curves.push_back([brep, id, use](double t) -> Eigen::Vector2d {
      return brep.domain_point(id, use, use.reversed ? 1 - t : t);
    });
  }
  result.surface = [brep, id](const Eigen::Vector2d& uv) -> Eigen::Vector3d { return brep.point(id, uv); };
  return result;
}

}  // namespace

HexSolid hex_solid(const Brep& brep, const std::string& name) {
  HexSolid result;
  result.name = name;
  for (const auto& vertex : brep.vertices().colwise()) result.vertices.emplace_back(vertex);
  for (std::size_t f = 0; f < brep.faces().size(); ++f)
    result.faces.push_back(solid_face(brep, FaceId(static_cast<int>(f)), name));
  return result;
}

}  // namespace isopatch::segmentation
