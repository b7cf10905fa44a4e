#pragma once

#include <string>
#include <vector>

#include "app/pages/scene.hpp"
#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::app {

/// What solids that became patches can be coloured by: the deviation from their faces (no value inside of
/// patches), and each patch's certified lower bound of det J, in its mean.
///
/// @param samples  of the patches, of which the report's are the first
std::vector<SceneField> parameterization_fields(const segmentation::ParameterizationReport& report,
                                                const iga::PartSamples& samples);

/// The page of patches without a solution.
/// @param model  the patches of `made`, connected
/// @return       HTML
std::string parameterization_html(const segmentation::ParameterizationReport& report,
                                  const geometry::MultiPatch& model, const std::string& title);

}  // namespace isopatch::app
