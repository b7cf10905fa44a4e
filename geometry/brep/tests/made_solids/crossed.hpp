#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>

/// Solids that are stacks of several directions, by name; mm.
std::map<std::string, TopoDS_Shape> crossed();
