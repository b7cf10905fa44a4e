#include "app/report_page.hpp"

#include <fmt/format.h>

#include "app/internal/json_values.hpp"
#include "app/report_scene.hpp"
#include "app/summary.hpp"

namespace isopatch::app {

Page report_page(const iga::ElasticField& field, const StoredModel& model, const std::string& study,
                 const std::string& summary) {
  const Json json = Json::parse(summary, nullptr, false);
  const bool read = json.is_object();
  Page page;
  page.kind = "report";
  page.program = fmt::format("isopatch {}", version());
  page.title = read ? json.value("title", "") : "";
  page.study = study;
  page.summary_json = read ? summary : "null";
  page.scene = report_scene(field, model, summary);
  return page;
}

std::string report_html(const iga::ElasticField& field, const std::string& study,
                        const std::string& summary) {
  const StoredModel model = stored_model(field.patches, summary);
  return to_html(report_page(field, model, study, summary));
}

}  // namespace isopatch::app
