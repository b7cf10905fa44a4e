#pragma once

#include <optional>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/decomposition/decomposition.hpp"
#include "segmentation/decomposition/decomposition_options.hpp"

namespace isopatch::segmentation {

/// A solid of triangles as tetrahedra around points.
struct StarPieces {
  geometry::CellComplex complex;  ///< of tetrahedra that meet side to side
  int pieces = 1;                 ///< between planes, each around one point
};

/// Whether there are two hundred plane faces and more, nine of ten of them triangles.
bool is_of_triangles(const geometry::Brep& solid);

/// The last resort for solids of triangles that nothing else divides: planes across the coordinate axes cut
/// it until each piece is seen whole from a point, and tetrahedra around it fill the piece, one for each
/// triangle and more where planes have cut. Many hexahedra, all faces as they are.
/// @return  nothing for a solid that is not of triangles, or where eight pieces do not do
/// @throws Error  as `cut_by_plane`, or where pieces do not meet side to side: says where
/// @cost  some seconds for 500 triangles
std::optional<StarPieces> star_pieces(const geometry::Brep& solid);

/// Their tetrahedra as hexahedra, four each, whatever `max_cells` says.
/// @return  nothing where there are no such pieces, or a hexahedron would be folded
std::optional<Decomposition> kept_triangles(const geometry::Brep& solid, const DecompositionOptions& options);

}  // namespace isopatch::segmentation
