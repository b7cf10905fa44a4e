#include "app/reports/report_page.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "app/base/provenance.hpp"
#include "app/plots/residual_plot.hpp"
#include "app/reports/convergence_plot.hpp"
#include "app/reports/parameterization_scene.hpp"
#include "app/reports/report_scene.hpp"
#include "app/reports/stage_scene.hpp"

namespace isopatch::app {
namespace {

// The plots have their titles inside.
std::vector<PagePlot> plots_of(const SummarizedSolver& solver) {
  const auto plot =
      residual_plot({{solver.method, solver.residual_history, solver.levels > 0}}, solver.tolerance);
  return plot ? std::vector<PagePlot>{{"", to_svg(*plot)}} : std::vector<PagePlot>{};
}

}  // namespace

Page report_page(const ReportContent& content) {
  Page page;
  page.kind = "report";
  page.program = fmt::format("isopatch {}", version());
  page.study = content.study;
  page.cases = content.cases;
  if (content.summary) {
    page.title = content.summary->title;
    page.summary_json = content.summary_json;
    page.plots = plots_of(content.summary->solver);
    if (const auto plot = convergence_plot(content.summary->levels, content.summary->asked_error))
      page.plots.push_back({"", to_svg(*plot)});
  }
  page.scene = report_scene(content.field, content.model, content.summary.value_or(RunSummary{}));
  page.blocks = stage_scene(content.stages);
  if (content.solids)
    for (SceneField& more : parameterization_fields(*content.solids, page.scene->samples))
      page.scene->fields.push_back(std::move(more));
  return page;
}

std::string report_html(const ReportContent& content) {
  return to_html(report_page(content));
}

}  // namespace isopatch::app
