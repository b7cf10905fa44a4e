#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pages/block_scene.hpp"
#include "app/problem/reconstructed_solids.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/patch_face.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::app {

/// The triangles of a solid; nothing where it cannot be triangulated.
std::optional<geometry::Tessellation> triangulated(const geometry::Brep& brep);

/// A solid as a piece: its faces as triangles and its edges, or these alone where it cannot be triangulated.
BlockPiece piece_of(const geometry::Brep& brep, const std::string& name, const std::string& body);

/// A piece for each face of a solid, called as the face, "face 3" where it has no name; none where the solid
/// cannot be triangulated.
std::vector<BlockPiece> face_pieces(const geometry::Brep& brep, const std::string& body);

/// The outside of a patch as a piece, with the lines of its elements.
/// @cost  some 300 points a side, and at least one for each element
BlockPiece patch_piece(const geometry::NurbsVolume& patch, const std::string& name);

/// A piece for each face that triangles were joined to, with the edges between it and others.
/// @param names  of the faces
/// @cost  O(T log T)
std::vector<BlockPiece> region_pieces(const SolidTriangles& triangles, const std::vector<std::string>& names);

}  // namespace isopatch::app
