#include "app/problem/cutting_json.hpp"

#include "app/base/internal/json_values.hpp"

namespace isopatch::app {
namespace {

Json body_json(const CutBody& body) {
  const segmentation::DecompositionReport& report = body.report;
  return {{"name", body.name},
          {"hexahedra", body.blocks},
          {"cuts", report.cuts},
          {"parts", report.cells == 0 ? 1 : report.cells},
          {"t_joints", report.t_joints},
          {"further_cuts", report.further_cuts},
          {"by_tetrahedra", report.by_tetrahedra},
          {"evaluations", report.evaluations},
          {"seconds", report.seconds}};
}

}  // namespace

std::string cutting_json_text(const CutSolids& solids) {
  Json bodies = Json::array();
  for (const CutBody& body : solids.cuts) bodies.push_back(body_json(body));
  return file_text({{"bodies", bodies}, {"warnings", solids.warnings}});
}

}  // namespace isopatch::app
