#pragma once

#include <XSControl_WorkSession.hxx>

#include "geometry/brep/opencascade/internal/exchange.hpp"

namespace isopatch::geometry {

/// Adds to what is lost the faces of spheres and tori that were made on the other side of their edges.
///
/// A loop on such a surface has a finite region on both sides, and the file means the one to the left of it.
/// The library takes the smaller one where a loop goes around no pole, and the solid that results is closed
/// and wrong.
void add_swapped_sides(const XSControl_WorkSession& session, FileShapes& result);

}  // namespace isopatch::geometry
