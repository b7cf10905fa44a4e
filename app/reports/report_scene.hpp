#pragma once

#include <string>

#include "app/pages/scene.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// Samples of a solution with everything that a summary says about places in it: supports, loads, probes,
/// largest values, warnings.
///
/// @param model    of the field's patches; must outlive the scene
/// @param summary  text of summary.json; what is missing in it is left out
Scene report_scene(const iga::ElasticField& field, const geometry::MultiPatch& model,
                   const std::string& summary, const iga::SamplingOptions& sampling = {});

}  // namespace isopatch::app
