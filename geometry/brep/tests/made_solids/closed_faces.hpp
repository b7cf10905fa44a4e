#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>

/// Solids with one face, a spline that closes on itself, by name, mm.
std::map<std::string, TopoDS_Shape> closed_faces();
