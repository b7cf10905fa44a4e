#pragma once

#include <Interface_InterfaceModel.hxx>
#include <XSControl_WorkSession.hxx>

#include "geometry/brep/opencascade/internal/exchange.hpp"

namespace isopatch::geometry {

/// The number in the label of an entity, "#443" or "D17"; 0 where it has none.
std::int64_t entity_number(const Interface_InterfaceModel& model, const Handle(Standard_Transient) & entity);

/// Adds what became of a file's entities: bodies and faces without a shape are lost, and what else could not
/// be read of shapes is a remark.
/// @param is_body_or_face  which entities must have become shapes
void add_remarks(const XSControl_WorkSession& session, bool (*is_body_or_face)(const Standard_Transient&),
                 FileShapes& result);

}  // namespace isopatch::geometry
