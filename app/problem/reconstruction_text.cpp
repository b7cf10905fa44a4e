#include "app/problem/reconstruction_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/problem/internal/reconstruction_json.hpp"

#include "app/base/engineering_units.hpp"

namespace isopatch::app {
namespace {

using geometry::SurfaceKind;
using segmentation::Region;

std::string figures_of(const Region& region) {
  if (region.spline)
    return fmt::format("spline of {} x {} control points", region.spline->size(0), region.spline->size(1));
  const geometry::Carrier& c = *region.carrier;
  const ScaledUnit unit = unit_for(c.radius, "m");
  switch (c.kind) {
    case SurfaceKind::cylinder:
    case SurfaceKind::sphere:
      return fmt::format("radius {:.6g} {}", c.radius / unit.factor, unit.symbol);
    case SurfaceKind::cone:
      return fmt::format("half angle {:.6g} deg", std::abs(c.half_angle.degrees()));
    case SurfaceKind::torus:
      return fmt::format("radii {:.6g} and {:.6g} {}", c.radius / unit.factor, c.second_radius / unit.factor,
                         unit.symbol);
    default:
      return fmt::format("normal ({:.4g}, {:.4g}, {:.4g})", c.axis.x() + 0.0, c.axis.y() + 0.0,
                         c.axis.z() + 0.0);
  }
}

Json face_json(const std::string& name, const Region& region) {
  if (region.spline)
    return Json{{"name", name},
                {"kind", "freeform"},
                {"area", region.area},
                {"triangles", region.triangles.size()},
                {"largest_deviation", region.deviation},
                {"degrees", {region.spline->degree(0), region.spline->degree(1)}},
                {"control_points", {region.spline->size(0), region.spline->size(1)}}};
  const geometry::Carrier& c = *region.carrier;
  Json face{{"name", name},
            {"kind", geometry::name(c.kind)},
            {"area", region.area},
            {"triangles", region.triangles.size()},
            {"largest_deviation", region.deviation},
            {"origin", to_json(c.origin)},
            {"axis", to_json(c.axis)}};
  if (c.kind != SurfaceKind::plane) face["radius"] = c.radius;
  if (c.kind == SurfaceKind::torus) face["second_radius"] = c.second_radius;
  if (c.kind == SurfaceKind::cone) face["half_angle"] = c.half_angle.degrees();
  return face;
}

}  // namespace

std::string reconstruction_text(const segmentation::Reconstruction& made) {
  const auto& report = made.report;
  std::string text =
      fmt::format("  {} triangles: {} faces ({}), {} edges, {} vertices\n", made.mesh.triangles.cols(),
                  made.regions.regions.size(), segmentation::kinds_text(made.regions),
                  made.brep.edges().size(), made.brep.vertices().cols());
  text += fmt::format(
      "  vertices off their surfaces by at most {:.2g} m, in the mean {:.2g} m; allowed were {:.2g} m\n",
      report.largest_deviation, report.mean_deviation, report.tolerance);
  text += fmt::format("  volume {}; of the triangles {}\n", with_unit(report.volume, "m^3"),
                      with_unit(report.mesh_volume, "m^3"));
  for (std::size_t f = 0; f < made.regions.regions.size(); ++f) {
    const Region& region = made.regions.regions[f];
    text += fmt::format("  {:<12} area {:<12}  {}\n", made.brep.faces()[f].name,
                        with_unit(region.area, "m^2"), figures_of(region));
  }
  return text;
}

Json reconstruction_json(const segmentation::Reconstruction& made) {
  const auto& report = made.report;
  Json faces = Json::array();
  for (std::size_t f = 0; f < made.regions.regions.size(); ++f)
    faces.push_back(face_json(made.brep.faces()[f].name, made.regions.regions[f]));
  return {{"triangles", made.mesh.triangles.cols()},
          {"vertices", made.mesh.vertices.cols()},
          {"edges", made.brep.edges().size()},
          {"tolerance", report.tolerance},
          {"largest_deviation", report.largest_deviation},
          {"mean_deviation", report.mean_deviation},
          {"mesh_volume", report.mesh_volume},
          {"volume", report.volume},
          {"seconds", report.seconds},
          {"remarks", report.remarks},
          {"faces", faces}};
}

std::string reconstruction_json_text(const segmentation::Reconstruction& made) {
  return file_text(reconstruction_json(made));
}

}  // namespace isopatch::app
