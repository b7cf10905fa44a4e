#include "geometry/brep/solid_error.hpp"

namespace isopatch::geometry {

SolidFault of_solid(SolidFault fault, const std::string& solid) {
  for (SolidFault::Face& face : fault.faces)
    if (face.solid.empty()) face.solid = solid;
  return fault;
}

}  // namespace isopatch::geometry
