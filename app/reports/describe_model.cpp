#include "app/reports/describe_model.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/base/engineering_units.hpp"
#include "app/base/internal/cut_list.hpp"
#include "app/base/place_text.hpp"
#include "app/results/internal/json_regions.hpp"

namespace isopatch::app {
namespace {

using geometry::MultiPatch;

std::string_view sign_name(geometry::JacobianSign sign) {
  switch (sign) {
    case geometry::JacobianSign::positive:
      return "positive";
    case geometry::JacobianSign::nonnegative:
      return "nonnegative";
    case geometry::JacobianSign::negative:
      return "negative";
    case geometry::JacobianSign::undecided:
      return "undecided";
  }
  return "undecided";
}

std::string triple(const std::array<int, 3>& values) {
  return fmt::format("{}x{}x{}", values[0], values[1], values[2]);
}

std::string patches_text(const ModelReport& report, bool all) {
  const std::size_t shown = all ? report.patches.size() : std::min(short_list, report.patches.size());
  std::string text = fmt::format("\npatches\n  {:>4}  {:<7} {:<12} {:<9} {:>12}  {:>7}  {}\n", "no", "degree",
                                 "points", "elements", "volume", "quality", "det J");
  for (std::size_t i = 0; i < shown; ++i) {
    const PatchReport& patch = report.patches[i];
    text += fmt::format("  {:>4}  {:<7} {:<12} {:<9} {:>12}  {:>7.3f}  {}{}{}\n", i, triple(patch.degree),
                        triple(patch.control_points), triple(patch.elements), with_unit(patch.volume, "m^3"),
                        patch.quality.min_scaled_jacobian, sign_name(patch.certificate.sign),
                        patch.rational ? ", rational" : "",
                        patch.was_left_handed ? ", left-handed in the file" : "");
  }
  return text + cut(shown, report.patches.size(), "patches");
}

/// Three digits; what rounds to zero is 0.
std::string normal_text(const Eigen::Vector3d& normal) {
  const auto rounded = [](double x) { return fmt::format("{:.3f}", std::round(1000 * x) / 1000 + 0.0); };
  return triple_text(rounded(normal[0]), rounded(normal[1]), rounded(normal[2]));
}

std::string faces_text(const MultiPatch& model, const ModelReport& report, bool all) {
  const std::size_t total = report.boundary_faces.size();
  const std::size_t shown = all ? total : std::min(short_list, total);
  std::string text = "\nboundary faces\n";
  for (std::size_t i = 0; i < shown; ++i) {
    const BoundaryFaceReport& face = report.boundary_faces[i];
    text += fmt::format("  {:<10} {:>12}  centre {}, normal {}\n", face.label, with_unit(face.area, "m^2"),
                        place_with_unit(face.centre, model.size()), normal_text(face.normal));
  }
  return text + cut(shown, total, "faces");
}

std::string boundaries_text(const MultiPatch& model, const ModelReport& report) {
  std::string text;
  for (const auto& boundary : model.boundaries()) {
    double area = 0;
    std::string labels;
    for (const auto& face : boundary.faces) {
      labels += fmt::format(" {}", model.label(face));
      for (const BoundaryFaceReport& known : report.boundary_faces)
        if (known.face == face) area += known.area;
    }
    text += fmt::format("  {:<12} {:>12} {}\n", boundary.name, with_unit(area, "m^2"), labels);
  }
  return text.empty() ? "" : "\nnamed boundaries\n" + text;
}

std::string bodies_text(const ModelReport& report) {
  if (report.bodies.size() == 1) return "";
  std::string text = "\nbodies that do not touch\n";
  for (const auto& body : report.bodies) {
    std::string patches;
    for (const PatchId id : body) patches += fmt::format(" {}", id.value);
    text += "  patches" + patches + "\n";
  }
  return text;
}

std::string non_matching_text(const ModelReport& report, bool all) {
  const std::size_t total = report.non_matching.size();
  if (total == 0) return "";
  const std::size_t shown = all ? total : std::min(short_list, total);
  std::string text = "\nfaces that meet without matching\n";
  for (std::size_t i = 0; i < shown; ++i) {
    const NonMatchingReport& pair = report.non_matching[i];
    text += fmt::format("  {:<10} {:<10} {:>12} +- {:.0e}  gap {}\n", pair.first, pair.second,
                        with_unit(pair.area, "m^2"), pair.area_error / pair.area, with_unit(pair.gap, "m"));
  }
  return text + cut(shown, total, "pairs");
}

Json face_json(const BoundaryFaceReport& face) {
  return {{"face", face.label},
          {"area", face.area},
          {"centre", to_json(face.centre)},
          {"normal", to_json(face.normal)}};
}

Json patch_json(const MultiPatch& model, const PatchReport& patch, int index) {
  const auto parameter = model.to_input(PatchId(index), patch.certificate.parameter);
  return {{"degree", patch.degree},
          {"control_points", patch.control_points},
          {"elements", patch.elements},
          {"rational", patch.rational},
          {"left_handed", patch.was_left_handed},
          {"volume", patch.volume},
          {"min_scaled_jacobian", patch.quality.min_scaled_jacobian},
          {"mean_scaled_jacobian", patch.quality.mean_scaled_jacobian},
          {"min_jacobian_at_gauss_points", patch.quality.min_jacobian},
          {"certificate",
           {{"sign", sign_name(patch.certificate.sign)},
            {"accepted", patch.certificate.accepted()},
            {"lower", patch.certificate.lower},
            {"upper", patch.certificate.upper},
            {"smallest", patch.certificate.smallest},
            {"parameter", to_json(Eigen::Vector3d(parameter))},
            {"point", to_json(patch.certificate.place)}}}};
}

Json non_matching_json(const ModelReport& report) {
  Json result = Json::array();
  for (const NonMatchingReport& pair : report.non_matching)
    result.push_back({{"first", pair.first},
                      {"second", pair.second},
                      {"area", pair.area},
                      {"area_error", pair.area_error},
                      {"gap", pair.gap}});
  return result;
}

Json probes_json(const BuiltProblem& problem) {
  const MultiPatch& model = problem.problem.discretization.model;
  Json result = Json::array();
  for (const LocatedProbe& probe : problem.probes)
    result.push_back(
        {{"name", probe.name},
         {"patch", probe.patch},
         {"parameter", to_json(Eigen::Vector3d(model.to_input(PatchId(probe.patch), probe.parameter)))},
         {"point", to_json(model.patch(PatchId(probe.patch)).point(probe.parameter))}});
  return result;
}

}  // namespace

std::string model_text(const MultiPatch& model, const ModelReport& report, bool all) {
  std::string text =
      contents_text(model, report) +
      (model.degenerate_faces().empty() ? ""
                                        : ", " + counted(model.degenerate_faces().size(), "collapsed face")) +
      "\n";
  text += fmt::format("{} control points, {} elements\n", with_separators(report.control_points),
                      with_separators(report.elements));
  text += fmt::format("volume {}, surface {}\n", with_unit(report.volume, "m^3"),
                      with_unit(report.boundary_area, "m^2"));
  text += fmt::format("box {} to {}\n", place_with_unit(report.box.min(), model.size()),
                      place_with_unit(report.box.max(), model.size()));
  text += fmt::format("largest gap at an interface {}\n", with_unit(report.largest_gap, "m"));
  text += patches_text(report, all) + bodies_text(report) + boundaries_text(model, report) +
          non_matching_text(report, all) + faces_text(model, report, all);
  return text;
}

std::string model_json_text(const MultiPatch& model, const ModelReport& report, const BuiltProblem* problem) {
  Json patches = Json::array();
  for (std::size_t i = 0; i < report.patches.size(); ++i)
    patches.push_back(patch_json(model, report.patches[i], static_cast<int>(i)));
  Json interfaces = Json::array();
  for (const auto& interface : model.interfaces())
    interfaces.push_back({{"first", model.label(interface.first)},
                          {"second", model.label(interface.second)},
                          {"gap", interface.gap}});
  Json faces = Json::array();
  for (const auto& face : report.boundary_faces) faces.push_back(face_json(face));
  Json boundaries = Json::object();
  for (const auto& boundary : model.boundaries()) {
    Json labels = Json::array();
    for (const auto& face : boundary.faces) labels.push_back(model.label(face));
    boundaries[boundary.name] = labels;
  }
  Json bodies = Json::array();
  for (const auto& body : report.bodies) {
    Json patch_ids = Json::array();
    for (const PatchId id : body) patch_ids.push_back(id.value);
    bodies.push_back(patch_ids);
  }
  Json json = {{"schema_version", 1},
               {"volume", report.volume},
               {"boundary_area", report.boundary_area},
               {"box",
                {{"min", to_json(Eigen::Vector3d(report.box.min()))},
                 {"max", to_json(Eigen::Vector3d(report.box.max()))}}},
               {"control_points", report.control_points},
               {"elements", report.elements},
               {"patches", patches},
               {"interfaces", interfaces},
               {"non_matching", non_matching_json(problem ? problem->report : report)},
               {"boundary_faces", faces},
               {"boundaries", boundaries},
               {"bodies", bodies}};
  if (problem) {
    json["supports"] = supports_json(problem->supports);
    json["loads"] = loads_json(problem->loads);
    json["probes"] = probes_json(*problem);
    json["warnings"] = texts_json(problem->warnings);
  }
  return file_text(json);
}

}  // namespace isopatch::app
