#pragma once

#include <string>

#include "segmentation/reconstruction/reconstruction.hpp"

namespace isopatch::app {

/// What came of the triangles, for people: faces by kind, how near they are, each face.
std::string reconstruction_text(const segmentation::Reconstruction& made);

/// The same and all figures as JSON; lengths are metres.
std::string reconstruction_json_text(const segmentation::Reconstruction& made);

}  // namespace isopatch::app
