#pragma once

#include <filesystem>

#include "app/study/blocks_input.hpp"
#include "geometry/base/progress.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"

namespace isopatch::app {

/// The solid that a file of triangles was made of; lengths are metres.
/// @param length_unit  m of one unit of the file
/// @throws Error as `geometry::read_triangles` and `segmentation::reconstruct` do, with the file's name
segmentation::Reconstruction reconstructed(const std::filesystem::path& file, double length_unit,
                                           const segmentation::ReconstructionOptions& options,
                                           const Progress& progress = {});

/// The solids of files, of which some may hold triangles: those are reconstructed, and warnings say how well.
/// @throws Error as `segmentation::read_solids` and `reconstructed` do
segmentation::ReadSolids solids_of_files(const BlocksInput& input, const Progress& progress = {});

}  // namespace isopatch::app
