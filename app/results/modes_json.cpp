#include "app/results/modes_json.hpp"

#include "app/base/internal/json_values.hpp"
#include "app/base/provenance.hpp"

namespace isopatch::app {

std::string modes_json(const Study& study, const iga::NaturalModes& found, bool not_matching,
                       const std::vector<Warning>& warnings) {
  Json modes = Json::array();
  for (const iga::NaturalMode& mode : found.modes)
    modes.push_back({{"frequency", mode.frequency},
                     {"kind", mode.is_rigid ? "rigid motion" : "elastic"},
                     {"residual", mode.residual}});
  Json timings = Json::object();
  for (const iga::PhaseTime& time : found.timings) timings[time.phase] = time.seconds;
  return file_text({{"schema_version", 1},
                    {"program", {{"name", "isopatch"}, {"version", version()}}},
                    {"title", study.title},
                    {"study", study.source},
                    {"coupling", "elimination"},
                    {"non_matching_coupling", not_matching ? "nitsche" : "none"},
                    {"modes", modes},
                    {"rigid_motions", found.rigid_motions},
                    {"worst_orthogonality", found.worst_orthogonality},
                    {"counted", found.counted},
                    {"counted_to", found.counted_to},
                    {"warnings", texts_json(warnings)},
                    {"timings", timings}});
}

}  // namespace isopatch::app
