#pragma once

#include <filesystem>
#include <string>

#include "app/problem/parameterized_model.hpp"
#include "geometry/brep/solid_error.hpp"

namespace isopatch::app {

/// The page about solids that could not be made patches: all that can be read of them, what is wrong marked.
///
/// Solids are read again, also open ones; what cannot be read is drawn by its outlines, or left out.
/// @param title  of the page
/// @param study  text of the study file, or ""
/// @return       HTML
std::string fault_html(const BlocksInput& input, const geometry::SolidError& error, const std::string& title,
                       const std::string& study);

/// The error's message with the page that shows where.
std::string shown_in(const geometry::SolidError& error, const std::filesystem::path& page);

}  // namespace isopatch::app
