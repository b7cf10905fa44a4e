#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/blocks_input.hpp"
#include "geometry/base/progress.hpp"
#include "segmentation/decomposition/cutting_error.hpp"
#include "segmentation/decomposition/decompose.hpp"

namespace isopatch::app {

/// How one body became blocks, or why it did not.
struct CutBody {
  geometry::BrepFile solid;  ///< its splines recognised, without blends that were removed
  std::vector<geometry::BrepFile> blocks;
  /// Of a body that was cut; nothing for one that was a hexahedron.
  std::optional<segmentation::Decomposition> cutting = {};
  std::optional<segmentation::CuttingError> failure = {};
  std::string tips = {};        ///< likewise of drill tips that were made flat
  std::string blends = {};      ///< what was removed or could not be, for people; "" for nothing
  std::string recognised = {};  ///< what splines of the file really are, as of `geometry::RecognisedBrep`
};

/// Solids as topological hexahedra.
struct CutSolids {
  std::vector<CutBody> bodies;
  std::vector<std::string> warnings;

  std::vector<geometry::BrepFile> blocks() const;  ///< of all bodies
  std::vector<std::string> body_names() const;     ///< by block: the body that it is a part of
};

/// Whether a solid is a block as it is: a topological hexahedron that a patch can follow.
bool is_block(const geometry::Brep& solid);

/// Reads solids and takes those apart that are no topological hexahedra; lengths are metres.
/// @param input     with a decomposition
/// @param progress  phases say which body it is, "body 2 of 5: cutting 'arm'", with details behind a tab
/// @throws Error as `read_solids` and `decompose` do
CutSolids cut_solids(const BlocksInput& input, const Progress& progress = {});

/// The same of solids that are read already.
CutSolids cut_solids(segmentation::ReadSolids read, const segmentation::DecompositionOptions& options,
                     const Progress& progress = {});

/// The same, but bodies that cannot be cut keep the reason, and the others go on.
/// @throws Error as `read_solids` does
CutSolids try_to_cut_solids(const BlocksInput& input, const Progress& progress = {});

/// The blocks of all bodies, and how they meet.
/// @throws Error as `segmentation::hex_model` does
segmentation::ReadBlocks put_together(const CutSolids& solids,
                                      const segmentation::AssemblyOptions& options = {});

/// A line for each body, for people.
std::string cutting_text(const CutSolids& solids);

}  // namespace isopatch::app
