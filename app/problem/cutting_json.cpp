#include "app/problem/cutting_json.hpp"

#include "app/problem/internal/body_json.hpp"

namespace isopatch::app {

Json body_json(const CutBody& body) {
  segmentation::DecompositionReport report;
  if (body.cutting) report = body.cutting->report;
  Json json = {{"name", body.solid.name},
               {"hexahedra", body.blocks.size()},
               {"cuts", report.cuts},
               {"parts", body.cutting ? report.cells : 1},
               {"t_joints", report.t_joints},
               {"t_joints_kept", report.t_joints_kept},
               {"further_cuts", report.further_cuts},
               {"by_tetrahedra", report.by_tetrahedra},
               {"blends", body.blends},
               {"tips", body.tips},
               {"seen_as", report.seen_as},
               {"evaluations", report.evaluations},
               {"seconds", report.seconds}};
  if (body.failure) json["error"] = body.failure->what();
  return json;
}

std::string cutting_json_text(const CutSolids& solids) {
  Json bodies = Json::array();
  for (const CutBody& body : solids.bodies) bodies.push_back(body_json(body));
  return file_text({{"bodies", bodies}, {"warnings", solids.warnings}});
}

}  // namespace isopatch::app
