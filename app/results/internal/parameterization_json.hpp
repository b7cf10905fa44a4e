#pragma once

// For .cpp files only: third-party types stay out of the headers that others include.

#include "app/base/internal/json_values.hpp"
#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::app {

/// The report in SI units; the key "parameterization" of summary.json.
Json parameterization_json(const segmentation::ParameterizationReport& report);

}  // namespace isopatch::app
