#pragma once

#include <optional>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// A stack with bores, slots and bosses across it as hexahedra.
struct CrossBoredCells {
  geometry::CellComplex complex;  ///< of hexahedra that meet side to side
  Eigen::Vector3d along;          ///< unit, of the stack
  int bores = 0;                  ///< across it, slots and bosses among them
  int slots = 0;                  ///< those that are not round
  int bosses = 0;                 ///< those that stand out
};

/// The direction of a stack that a solid looks like but for bores, slots and bosses across it; nothing of
/// others.
std::optional<Eigen::Vector3d> bored_across(const geometry::Brep& solid);

/// Whether a solid looks like a stack with bores across it that meet each other or bores along it.
bool bores_meet(const geometry::Brep& solid);

/// Divides a stack with bores at right angles to its direction: hydraulic blocks, drilled bars and forks.
/// Round bosses stand on planes, with what is turned about their axis: shanks of forks, studs, nozzles. Bores
/// end in planes, in wider bores that they cross, or in bores along the stack. The stack without them is
/// divided (see `Stack`) so that each begins within one rectangle; then the column of hexahedra below it is
/// divided around the bore, wide ones first.
/// @return  nothing for a solid that does not look so
/// @throws Error unsupported  it looks so, but there is no room beside a bore, or a drawing cannot be
/// divided: names the place
/// @cost  some seconds for each direction along which it looks so; the first that will do is taken, those
/// with the fewest bores first
std::optional<CrossBoredCells> cross_bored_cells(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
