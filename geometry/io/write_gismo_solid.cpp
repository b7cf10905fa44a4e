#include "geometry/io/write_gismo_solid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isopatch::geometry {
namespace {

std::string knots_text(const KnotVector& knots, const std::string& attributes) {
  std::string text =
      fmt::format("<Basis type=\"BSplineBasis\"{}><KnotVector degree=\"{}\">", attributes, knots.degree());
  for (const double knot : knots.knots()) text += fmt::format("{:.17g} ", knot);
  return text + "</KnotVector></Basis>\n";
}

std::string bases_text(const NurbsCurve& curve) {
  return knots_text(curve.knots(0), "");
}

std::string bases_text(const NurbsSurface& surface) {
  return "<Basis type=\"TensorBSplineBasis2\">\n" + knots_text(surface.knots(0), " index=\"0\"") +
         knots_text(surface.knots(1), " index=\"1\"") + "</Basis>\n";
}

/// @param plain, rational  type of the geometry; @param rational_basis  of its basis
template <int D>
std::string spline_text(const Nurbs<D>& spline, int coordinates, const char* plain, const char* rational,
                        const char* rational_basis) {
  std::string text = fmt::format("<Geometry type=\"{}\">\n", spline.is_rational() ? rational : plain);
  if (spline.is_rational()) {
    text += fmt::format("<Basis type=\"{}\">\n{}<weights>", rational_basis, bases_text(spline));
    for (const double weight : spline.weights()) text += fmt::format("{:.17g} ", weight);
    text += "</weights>\n</Basis>\n";
  } else {
    text += bases_text(spline);
  }
  text += fmt::format("<coefs geoDim=\"{}\">\n", coordinates);
  for (const auto& point : spline.control_points().colwise()) {
    for (int d = 0; d < coordinates; ++d) text += fmt::format("{:.17g} ", point(d));
    text += "\n";
  }
  return text + "</coefs>\n</Geometry>\n";
}

std::string surface_text(const TrimmedSurface& surface, std::size_t id) {
  std::string text = fmt::format("<TrimSurface id=\"{}\">\n", id);
  text += spline_text(surface.surface, 3, "TensorBSpline2", "TensorNurbs2", "TensorNurbsBasis2");
  text += "<PlanarDomain>\n";
  for (std::size_t i = 0; i < surface.loops.size(); ++i) {
    text += fmt::format("<CurveLoop index=\"{}\">\n", i);
    for (const NurbsCurve& curve : surface.loops[i])
      text += spline_text(curve, 2, "BSpline", "NURBS", "NurbsBasis");
    text += "</CurveLoop>\n";
  }
  return text + "</PlanarDomain>\n</TrimSurface>\n";
}

}  // namespace

std::string to_gismo_solid(const SolidBoundary& solid) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml>\n";
  for (std::size_t i = 0; i < solid.surfaces.size(); ++i)
    if (solid.surfaces[i]) text += surface_text(*solid.surfaces[i], i);
  const std::size_t faces = solid.corners.faces.size();
  text += fmt::format("<Solid vertices=\"{}\" faces=\"{}\" volumes=\"1\" id=\"0\">\n<Vertex>\n",
                      solid.corners.vertices.cols(), faces);
  for (const auto& p : solid.corners.vertices.colwise())
    text += fmt::format("{:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
  text += "</Vertex>\n<Face>\n";
  for (std::size_t i = 0; i < faces; ++i) {
    const bool given = i < solid.surfaces.size() && solid.surfaces[i];
    text += fmt::format("{} {} {}\n", solid.corners.faces[i].size(), fmt::join(solid.corners.faces[i], " "),
                        given ? static_cast<int>(i) : -1);
  }
  text += fmt::format("</Face>\n<Volume>{}", faces);
  for (std::size_t i = 0; i < faces; ++i) text += fmt::format(" {}", i);
  return text + "</Volume>\n</Solid>\n</xml>\n";
}

}  // namespace isopatch::geometry
