#pragma once

// For .cpp files only: third-party types stay out of the headers that others include.

#include "app/base/internal/json_values.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"

namespace isopatch::app {

/// What came of the triangles with all figures, SI units.
Json reconstruction_json(const segmentation::Reconstruction& made);

}  // namespace isopatch::app
