#pragma once

#include "app/pages/scene.hpp"
#include "app/results/run_summary.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// Samples of a solution with everything that a summary says about places in it: supports, loads, probes,
/// largest values, warnings.
///
/// @param model    of the field's patches; must outlive the scene
Scene report_scene(const iga::ElasticField& field, const geometry::MultiPatch& model,
                   const RunSummary& summary, const iga::SamplingOptions& sampling = {});

}  // namespace isopatch::app
