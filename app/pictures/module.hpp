#pragma once

#include <string>

#include "app/pictures/picture.hpp"

// What the drawing module offers. It is loaded when a picture is drawn and not before: VTK's rendering
// libraries would otherwise slow every start of the program.
extern "C" {

/// Why a display (":0") cannot be drawn on; empty if it can.
void isopatch_display_problem(const std::string& display, std::string& problem);

/// The bytes of a PNG.
/// @throws isopatch::Error
void isopatch_draw(const isopatch::app::Picture& picture, const std::string& display, std::string& png);
}
