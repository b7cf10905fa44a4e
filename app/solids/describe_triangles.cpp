#include "app/solids/describe_triangles.hpp"

#include <fmt/format.h>

#include <utility>

#include "app/base/engineering_units.hpp"
#include "app/base/internal/json_values.hpp"
#include "app/problem/cut_solids.hpp"
#include "app/problem/internal/reconstruction_json.hpp"
#include "app/problem/reconstructed_solids.hpp"
#include "app/problem/reconstruction_text.hpp"
#include "app/solids/describe_solid.hpp"
#include "geometry/brep/recognise_carriers.hpp"
#include "geometry/io/read_triangles.hpp"
#include "geometry/mesh/mend.hpp"
#include "geometry/mesh/weld.hpp"

namespace isopatch::app {
namespace {

std::string unit_text(const InputFile& input, const std::optional<double>& metres) {
  if (!input.length_unit.empty()) return input.length_unit;
  return metres ? with_unit(*metres, "m") + ", as the file says"
                : "m, since the file states none; --length-unit says otherwise";
}

/// Volume if they bound a solid, as `reconstruct` sees them.
std::optional<double> bounded_volume(const geometry::TriangleMesh& mesh) {
  try {
    return volume(geometry::mended(mesh, mesh.grain).mesh);
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

TriangleReport triangle_report(const InputFile& input, const Progress& progress) {
  progress("reading the triangles", 0);
  geometry::MeasuredTriangles read = geometry::read_triangles(input.path);
  TriangleReport report;
  report.unit = unit_text(input, read.metres);
  const geometry::TriangleMesh mesh = in_metres(
      std::move(read), input.length_unit.empty() ? std::nullopt : std::optional(length_unit(input)));
  report.triangles = mesh.triangles.cols();
  report.vertices = geometry::weld(mesh, 0).mesh.vertices.cols();
  for (const auto& vertex : mesh.vertices.colwise()) report.box.extend(Eigen::Vector3d(vertex));
  report.area = area(mesh);
  report.volume = bounded_volume(mesh);
  try {
    report.made = segmentation::reconstruct(mesh, {}, progress);
    const geometry::RecognisedBrep found = geometry::recognise_carriers(report.made->brep);
    if (!is_block(found.brep)) report.prospect = segmentation::prospect(found.brep);
  } catch (const Error& error) {
    report.failure = error;
  }
  return report;
}

std::string triangles_text(const TriangleReport& report) {
  std::string text =
      fmt::format("{} triangles, {} vertices, unit of length: {}\n", with_separators(report.triangles),
                  with_separators(report.vertices), report.unit);
  if (!report.box.isEmpty()) {
    const double size = report.box.diagonal().norm();
    text += fmt::format("box {} to {}\n", place_with_unit(report.box.min(), size),
                        place_with_unit(report.box.max(), size));
  }
  text += fmt::format(
      "surface {}, {}\n", with_unit(report.area, "m^2"),
      report.volume ? fmt::format("closed, volume {}", with_unit(*report.volume, "m^3")) : "bounds no solid");
  if (!report.made) return text;
  text += "reconstruction:\n" + reconstruction_text(*report.made);
  for (const std::string& remark : report.made->report.remarks) text += fmt::format("  {}\n", remark);
  return text + fmt::format("segmentation: {}\n", outlook_text(report.prospect));
}

std::string triangles_json_text(const TriangleReport& report) {
  Json json = {{"triangles", report.triangles},
               {"vertices", report.vertices},
               {"unit", report.unit},
               {"box", {{"min", to_json(report.box.min())}, {"max", to_json(report.box.max())}}},
               {"area", report.area},
               {"closed", report.volume.has_value()},
               {"volume", report.volume ? Json(*report.volume) : Json()},
               {"reconstruction", report.made ? reconstruction_json(*report.made) : Json()},
               {"segmentation", report.made ? Json(outlook_text(report.prospect)) : Json()},
               {"failure", report.failure ? Json(report.failure->what()) : Json()}};
  return file_text(json);
}

}  // namespace isopatch::app
