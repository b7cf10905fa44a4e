#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>

/// Stacks along z but for their rounds, by name; mm.
std::map<std::string, TopoDS_Shape> rounds();
