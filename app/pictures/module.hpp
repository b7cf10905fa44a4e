#pragma once

#include <string>

#include "app/pictures/picture.hpp"

// What the drawing module offers. It is loaded when a picture is drawn and not before: VTK's rendering
// libraries would otherwise slow every start of the program.
extern "C" {

/// Why a display (":0") cannot be drawn on; empty if it can.
std::string isopatch_display_problem(const std::string& display);

/// The bytes of a PNG.
/// @throws isopatch::Error
std::string isopatch_draw(const isopatch::app::Picture& picture, const std::string& display);
}
