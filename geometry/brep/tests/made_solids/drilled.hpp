#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>

/// Blocks with bores that cross, by name; mm.
std::map<std::string, TopoDS_Shape> drilled();
