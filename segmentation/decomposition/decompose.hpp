#pragma once

#include <string>
#include <vector>

#include "geometry/base/progress.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/decomposition/combinatorics/decomposition_search.hpp"
#include "segmentation/decomposition/cutting/cut_cell.hpp"

namespace isopatch::segmentation {

struct DecompositionOptions {
  SearchOptions search = {.beam = 12, .branches = 16, .evaluations = 20000, .refusals = 5000, .cost = {.t_joint = 2}};
  CutOptions cut = {};
  int max_cells = 2000;  ///< at most so many cells while sides are made to meet; range 1 ..
};
void validate(const DecompositionOptions& options);

/// How a solid was taken apart.
struct DecompositionReport {
  int cuts = 0;            ///< that the search made
  int cells = 0;           ///< base solids that it ended with
  int t_joints = 0;        ///< sides then that met others in parts
  int further_cuts = 0;    ///< that made them meet side to side
  bool by_tetrahedra = false;  ///< instead of further cuts: all cells divided around a point inside
  int hexahedra = 0;       ///< in the end
  int evaluations = 0;     ///< cuts tried while searching
  double seconds = 0;
};

struct Decomposition {
  geometry::CellComplex complex;  ///< of hexahedra that meet side to side
  DecompositionReport report;
};

/// Takes a solid apart into topological hexahedra that meet side to side, by cutting loops.
///
/// Cuts go through concave edges first. Every cell becomes a hexahedron, a prism or a tetrahedron; cuts that
/// divide a side are carried on through its neighbours, then templates make hexahedra of all.
/// @param name  of the solid, for messages
/// @throws Error not_three_connected  the graph of its sides is not 3-connected: names the pair
/// @throws Error unsupported  no way was found: says what stopped it
Decomposition decompose(const geometry::Brep& solid, const std::string& name, const DecompositionOptions& options = {},
                        const Progress& progress = {});

}  // namespace isopatch::segmentation
