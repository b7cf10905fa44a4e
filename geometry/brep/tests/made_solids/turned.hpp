#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>

/// Solids turned about an axis, by name, mm.
std::map<std::string, TopoDS_Shape> turned_solids();
