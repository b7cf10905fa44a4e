#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>

/// Stacks along z with slots along y through walls that are plane, round and freeform, by name; mm.
std::map<std::string, TopoDS_Shape> slotted();
