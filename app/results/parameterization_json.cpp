#include "app/results/internal/parameterization_json.hpp"

#include <fmt/format.h>

namespace isopatch::app {
namespace {

using geometry::HexFaceUse;
using segmentation::FaceReport;
using segmentation::ParameterizationReport;

Json patch_json(const segmentation::PatchReport& patch) {
  return {{"name", patch.name},
          {"certified", patch.certificate.accepted()},
          {"determinant_bound", patch.certificate.lower},
          {"min_scaled_jacobian", patch.quality.min_scaled_jacobian},
          {"mean_scaled_jacobian", patch.quality.mean_scaled_jacobian},
          {"histogram", patch.histogram},
          {"volume", patch.volume},
          {"control_points", patch.control_points},
          {"optimized", patch.moved}};
}

Json face_json(const FaceReport& face) {
  Json sides = Json::array();
  for (const HexFaceUse& use : face.uses)
    sides.push_back(fmt::format("{}:{}", use.side.block.value, name(use.side.side)));
  return {{"name", face.name}, {"sides", sides}, {"deviation", face.deviation}, {"gap", face.gap}};
}

}  // namespace

Json parameterization_json(const ParameterizationReport& report) {
  Json patches = Json::array(), faces = Json::array();
  for (const auto& patch : report.patches) patches.push_back(patch_json(patch));
  for (const auto& face : report.faces) faces.push_back(face_json(face));
  return {{"certified", report.certified()},
          {"size", report.size},
          {"tolerance", report.tolerance},
          {"largest_deviation", report.worst_face().deviation},
          {"largest_deviation_at", report.worst_face().name},
          {"largest_gap", report.largest_gap},
          {"patches", patches},
          {"faces", faces},
          {"rounds", report.rounds},
          {"evaluations", report.evaluations},
          {"seconds", report.seconds}};
}

}  // namespace isopatch::app
