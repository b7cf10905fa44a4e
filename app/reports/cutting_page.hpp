#pragma once

#include <string>
#include <vector>

#include "app/pages/block_scene.hpp"
#include "app/problem/cut_solids.hpp"

namespace isopatch::app {

/// The page of solids that were cut: their parts after the cuts, the blocks in the end, T-joints, what was
/// done. Of a body that was given up what had been cut by then, or all of it with its faulty faces.
/// @param title     of the page
/// @param t_joints  that are left, in words
/// @return          HTML
/// @cost  a triangulation of each part and block
std::string cutting_html(const CutSolids& solids, const std::string& title,
                         const std::vector<std::string>& t_joints = {});

/// The page of one body that was given up in a run.
/// @param study   text of the study file
/// @param before  what was finished
std::string cutting_fault_html(const segmentation::CuttingError& error, const std::string& title,
                               const std::string& study, std::vector<BlockStage> before = {});

/// "block_3.step": the file of a block in the folder that `isopatch segment` writes.
std::string block_file_name(std::size_t block);

}  // namespace isopatch::app
