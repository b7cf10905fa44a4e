#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pages/block_scene.hpp"
#include "app/problem/stage_folder.hpp"
#include "app/study/blocks_input.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {

/// More triangles than these are not drawn: a page would take hundreds of megabytes.
inline constexpr std::int64_t most_drawn_triangles = 300'000;

/// What came of each stage, drawn from its file: triangles by the faces that they were joined to, the solid's
/// faces, hexahedra, patches. Files that are missing or have changed since are left out.
/// @return  nothing if there is nothing to show
std::optional<BlockScene> stage_scene(const std::vector<StageReport>& stages);

/// The page of stages alone, of a run that was to end before the solution.
/// @param study  text of the study file
/// @return       HTML
std::string stages_html(const std::vector<StageReport>& stages, const std::string& title,
                        const std::string& study);

/// The page of triangles that no solid was made of: those that lie on no surface in red or, where they bound
/// no solid, the edges that are in the way.
/// @return  HTML; nothing if the triangles cannot be read or are too many
std::optional<std::string> triangles_fault_html(const BlocksInput& input, const Error& error,
                                                const std::string& title, const std::string& study);

}  // namespace isopatch::app
