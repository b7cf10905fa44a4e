#pragma once

#include <string>
#include <vector>

#include "app/study/keys.hpp"

namespace isopatch::app {

/// All sections in the order of the documentation.
std::vector<SectionText> study_sections();

/// The documentation of all keys as Markdown, or of the sections whose name contains `topic`.
/// @throws Error invalid_argument if no section or key has that name
std::string study_documentation(const std::string& topic = {});

}  // namespace isopatch::app
