#pragma once

#include <XSControl_WorkSession.hxx>

#include "geometry/brep/opencascade/internal/exchange.hpp"

namespace isopatch::geometry {

/// Adds what became of a file's entities: bodies and faces without a shape are lost, and what else could not
/// be read of shapes is a remark.
/// @param is_body_or_face  which entities must have become shapes
void add_remarks(const XSControl_WorkSession& session, bool (*is_body_or_face)(const Standard_Transient&),
                 FileShapes& result);

}  // namespace isopatch::geometry
