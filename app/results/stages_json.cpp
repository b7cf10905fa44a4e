#include <fmt/format.h>

#include "app/results/internal/stages_json.hpp"

namespace isopatch::app {

Json stages_json(const std::vector<StageReport>& stages) {
  Json result = Json::array();
  for (const StageReport& stage : stages)
    result.push_back(
        {{"name", name_of(stage_choices(), stage.stage)},
         {"kept", stage.kept},
         {"file",
          stage.file.empty() ? "" : fmt::format("{}/{}", stage_folder_name, stage.file.filename().string())},
         {"made", stage.made},
         {"seconds", stage.seconds},
         {"content", fmt::format("{:016x}", stage.content)}});
  return result;
}

}  // namespace isopatch::app
