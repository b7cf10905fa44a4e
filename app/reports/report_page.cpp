#include "app/reports/report_page.hpp"

#include <fmt/format.h>

#include "app/base/internal/json_values.hpp"
#include "app/base/provenance.hpp"
#include "app/plots/residual_plot.hpp"
#include "app/reports/parameterization_scene.hpp"
#include "app/reports/report_scene.hpp"
#include "app/results/summary.hpp"

namespace isopatch::app {
namespace {

// The plots have their titles inside.
std::vector<PagePlot> plots_of(const Json& summary) {
  const Json solver = summary.value("solver", Json::object());
  ResidualHistory history{solver.value("method", ""), {}, solver.value("levels", 0) > 0};
  for (const Json& residual : solver.value("residual_history", Json::array()))
    if (residual.is_number()) history.values.push_back(residual.get<double>());
  const auto plot = residual_plot({history}, solver.value("tolerance", 0.));
  return plot ? std::vector<PagePlot>{{"", to_svg(*plot)}} : std::vector<PagePlot>{};
}

}  // namespace

Page report_page(const iga::ElasticField& field, const geometry::MultiPatch& model, const std::string& study,
                 const std::string& summary) {
  const Json json = Json::parse(summary, nullptr, false);
  const bool read = json.is_object();
  Page page;
  page.kind = "report";
  page.program = fmt::format("isopatch {}", version());
  page.title = read ? json.value("title", "") : "";
  page.study = study;
  page.summary_json = read ? summary : "null";
  if (read) page.plots = plots_of(json);
  page.scene = report_scene(field, model, summary);
  return page;
}

std::string report_html(const iga::ElasticField& field, const geometry::MultiPatch& model,
                        const std::string& study, const std::string& summary,
                        const segmentation::ParameterizationReport* solids) {
  Page page = report_page(field, model, study, summary);
  if (solids)
    for (SceneField& more : parameterization_fields(*solids, page.scene->samples))
      page.scene->fields.push_back(std::move(more));
  return to_html(page);
}

}  // namespace isopatch::app
