#include "app/pages/page.hpp"

#include <nlohmann/json.hpp>

#include "app/pages/internal/web_files.hpp"

namespace isopatch::app {
namespace {

using Json = nlohmann::ordered_json;

std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Inside a script element no "</" may appear, and "<!--" would start a comment; JSON can say < otherwise.
std::string for_script(const std::string& json) {
  std::string result;
  result.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

std::string for_html(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (c == '<')
      result += "&lt;";
    else if (c == '&')
      result += "&amp;";
    else
      result += c;
  return result;
}

// Texts of large blocks are put together as text; parsing them again would take several times their memory.
std::string data_json(const Page& page) {
  std::string plots;
  for (const PagePlot& plot : page.plots)
    plots += (plots.empty() ? "" : ",") + ("{\"title\":" + quoted(plot.title) + ",\"section\":" +
                                           quoted(plot.section) + ",\"svg\":" + quoted(plot.svg) + "}");
  std::string cases;
  for (const PageLink& link : page.cases)
    cases += (cases.empty() ? "" : ",") +
             ("{\"name\":" + quoted(link.name) + ",\"address\":" + quoted(link.address) +
              ",\"current\":" + (link.is_current ? "true" : "false") + "}");
  return "{\"kind\":" + quoted(page.kind) + ",\"program\":" + quoted(page.program) +
         ",\"title\":" + quoted(page.title) + ",\"study\":" + quoted(page.study) +
         ",\"summary\":" + page.summary_json + ",\"plots\":[" + plots + "],\"cases\":[" + cases +
         "],\"scene\":" + (page.scene ? scene_json(*page.scene) : "null") +
         ",\"faults\":" + (page.faults ? fault_scene_json(*page.faults) : "null") +
         ",\"blocks\":" + (page.blocks ? block_scene_json(*page.blocks) : "null") + "}";
}

void replace_marker(std::string& text, std::string_view marker, std::string_view by) {
  for (std::size_t at = text.find(marker); at != std::string::npos; at = text.find(marker, at + by.size()))
    text.replace(at, marker.size(), by);
}

}  // namespace

std::string to_html(const Page& page) {
  std::string html(web_page());
  replace_marker(html, "<!--isopatch:title-->", for_html(page.title.empty() ? page.program : page.title));
  replace_marker(html, "/*isopatch:style*/", web_style());
  replace_marker(html, "/*isopatch:scripts*/", web_scripts());
  replace_marker(html, "/*isopatch:data*/", for_script(data_json(page)));
  return html;
}

}  // namespace isopatch::app
