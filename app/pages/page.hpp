#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pages/block_scene.hpp"
#include "app/pages/fault_scene.hpp"
#include "app/pages/scene.hpp"

namespace isopatch::app {

/// A drawing inside a page.
struct PagePlot {
  std::string title;  ///< empty if it is inside the drawing
  std::string svg;
  std::string section = {};  ///< heading of the part of the page that it belongs to, where there are several
};

/// Another page of the same kind, such as that of another load case.
struct PageLink {
  std::string name;
  std::string address;      ///< relative to the page
  bool is_current = false;  ///< the page itself
};

/// What a page says. Texts in JSON are SI values as the files of that name have them.
struct Page {
  std::string kind;     ///< "report", "compare", "model", "verification", "faults", "blocks" or "stages"
  std::string program;  ///< "isopatch 0.1.0"
  std::string title;
  std::string study;                  ///< text of the study file
  std::string summary_json = "null";  ///< text of summary.json, or compare.json
  std::vector<PagePlot> plots;
  std::vector<PageLink> cases = {};  ///< of a report: the pages of all load cases
  std::optional<Scene> scene = {};
  std::optional<FaultScene> faults = {};  ///< of a page of that kind
  std::optional<BlockScene> blocks = {};  ///< of blocks and stages; of a report what its patches came from
};

/// A page as one HTML file that needs nothing else, neither network nor server.
std::string to_html(const Page& page);

}  // namespace isopatch::app
