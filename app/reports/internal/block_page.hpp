#pragma once

// For .cpp files of this library only, as json_values.hpp is.

#include <string>

#include "app/base/internal/json_values.hpp"
#include "app/pages/block_scene.hpp"

namespace isopatch::app {

/// A page whose picture is solids in pieces.
/// @param kind   "blocks" or "stages"
/// @param size   of what is drawn, m: for the unit of lengths
/// @param study  text of the study file
/// @return       HTML
std::string block_page_html(const std::string& kind, BlockScene scene, double size, const Json& summary,
                            const std::string& title, const std::string& study);

}  // namespace isopatch::app
