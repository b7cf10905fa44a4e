#pragma once

#include <vector>

#include "segmentation/pieces/internal/piece.hpp"

namespace isopatch::segmentation {

/// Two pieces that meet in a plane.
struct Meeting {
  geometry::PlaneSurface plane;  ///< its x runs along a piece of which it is a wall, if it is of one
  int first, second;             ///< numbers of the pieces
};

/// Where pieces meet.
/// @throws Error unsupported  a plane in which the directions of both pieces are at no right angle
std::vector<Meeting> meetings(const std::vector<Piece>& pieces);

/// A divided piece.
struct MetPiece {
  geometry::CellComplex complex;
  Eigen::Vector3d along;  ///< unit; the axis of one that is turned
};

/// Divides all pieces so that their hexahedra meet in whole sides. Turned ones come first, then those of
/// which a plane is a wall: pieces that meet them with a floor take their sides over into their drawings. Of
/// two that both meet with floors the second takes over the chords of the first.
/// @param with_sockets  boxes that something round stands on are divided as `socket_cells` does
/// @throws Error unsupported  a drawing that cannot be divided, pieces that need no end of divisions
std::vector<MetPiece> met_pieces(const std::vector<Piece>& pieces, bool with_sockets = false);

}  // namespace isopatch::segmentation
