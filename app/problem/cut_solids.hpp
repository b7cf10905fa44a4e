#pragma once

#include <string>
#include <vector>

#include "app/study/blocks_input.hpp"
#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// How one body became blocks.
struct CutBody {
  std::string name;
  int blocks = 1;
  segmentation::DecompositionReport report;  ///< of a body that was a hexahedron all zero but for that
};

/// Solids as topological hexahedra.
struct CutSolids {
  std::vector<geometry::BrepFile> blocks;
  std::vector<std::string> bodies;  ///< by block: the body that it is a part of
  std::vector<CutBody> cuts;        ///< by body
  std::vector<std::string> warnings;
};

/// Reads solids and takes those apart that are no topological hexahedra; lengths are metres.
/// @param input  with a decomposition
/// @throws Error as `read_solids` and `decompose` do
CutSolids cut_solids(const BlocksInput& input, const Progress& progress = {});

/// A line for each body, for people.
std::string cutting_text(const CutSolids& solids);

}  // namespace isopatch::app
