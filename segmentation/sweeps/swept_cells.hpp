#pragma once

#include <optional>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"

namespace isopatch::segmentation {

/// A solid as columns of hexahedra over quadrilaterals of its profile.
struct SweptCells {
  geometry::CellComplex complex;  ///< of hexahedra that meet side to side
  Eigen::Vector3d along;          ///< unit
  int quadrilaterals = 0, levels = 0;
};

/// Divides a solid that is a stack of prisms: its walls all along one direction, its floors across it. Bores,
/// slots, pockets and bosses of that direction among them; holes through it and closed edges do not matter.
///
/// The outlines of all floors are laid over each other, that drawing is divided into quadrilaterals, and these
/// are swept from floor to floor. Of several directions the one with the fewest hexahedra is taken. Walls are exact: planes,
/// or a curve times a line.
/// @return  nothing for a solid that is no such stack
/// @throws Error unsupported  a profile that cannot be divided, naming the place
std::optional<SweptCells> swept_cells(const geometry::Brep& solid,
                                      const QuadrangulationOptions& options = {});

}  // namespace isopatch::segmentation
