#pragma once

#include <string>

#include "app/pages/page.hpp"
#include "geometry/multi_patch.hpp"
#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::app {

/// The report of a solved study, made of what results.h5 holds.
///
/// @param field    the solution
/// @param model    of its patches; must outlive the page
/// @param study    text of the study file
/// @param summary  text of summary.json
/// @cost  that of sample_part
Page report_page(const iga::ElasticField& field, const geometry::MultiPatch& model, const std::string& study,
                 const std::string& summary);

/// report_page as the text of report.html.
/// @param solids  how solids became the model's patches, for more fields to colour by; may be null
std::string report_html(const iga::ElasticField& field, const geometry::MultiPatch& model,
                        const std::string& study, const std::string& summary,
                        const segmentation::ParameterizationReport* solids = nullptr);

}  // namespace isopatch::app
