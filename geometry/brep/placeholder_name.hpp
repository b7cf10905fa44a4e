#pragma once

#include <string_view>

namespace isopatch::geometry {

/// Whether a name is what programs write where they have none to give: OpenCASCADE itself, FreeCAD and gmsh
/// through it, Rhino, CATIA and others.
inline bool is_placeholder_name(std::string_view name) {
  for (const std::string_view word :
       {"", "NONE", "''", "Face", "SOLID", "SHELL", "COMPOUND", "COMPSOLID", "Rhino Product", "(Unsaved)",
        "the product name", "Unnamed", "Open CASCADE Shape Model"})
    if (name == word) return true;
  return name.starts_with("Open CASCADE STEP translator");
}

}  // namespace isopatch::geometry
