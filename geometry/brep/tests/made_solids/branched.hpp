#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>

/// Turned solids with branches across their axis, by name; mm.
std::map<std::string, TopoDS_Shape> branched();
