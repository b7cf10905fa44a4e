#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pages/page.hpp"
#include "app/results/run_summary.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::app {

/// What the report of a solved study is made of: the run itself, or what results.h5 holds of it.
struct ReportContent {
  const iga::ElasticField& field;     ///< the solution
  const geometry::MultiPatch& model;  ///< of its patches; must outlive the page
  std::string study;                  ///< text of the study file
  std::string summary_json;           ///< text of summary.json, which goes onto the page as it is
  std::optional<RunSummary> summary;  ///< what it says; without one the text is left out
  /// How solids became the model's patches, for more fields to colour by; may be null.
  const segmentation::ParameterizationReport* solids = nullptr;
  std::vector<PageLink> cases = {};      ///< pages of the load cases
  std::vector<StageReport> stages = {};  ///< from the file to the patches, to be shown
};

/// @cost  that of sample_part
Page report_page(const ReportContent& content);

/// report_page as the text of report.html.
std::string report_html(const ReportContent& content);

}  // namespace isopatch::app
