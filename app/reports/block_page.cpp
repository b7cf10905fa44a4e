#include <fmt/format.h>

#include <utility>

#include "app/base/engineering_units.hpp"
#include "app/base/provenance.hpp"
#include "app/pages/page.hpp"
#include "app/reports/internal/block_page.hpp"

namespace isopatch::app {

std::string block_page_html(const std::string& kind, BlockScene scene, double size, const Json& summary,
                            const std::string& title, const std::string& study) {
  scene.length = model_length_unit(size);
  Page page;
  page.kind = kind;
  page.program = fmt::format("isopatch {}", version());
  page.title = title;
  page.study = study;
  page.summary_json = summary.dump(-1, ' ', false, Json::error_handler_t::replace);
  page.blocks = std::move(scene);
  return to_html(page);
}

}  // namespace isopatch::app
