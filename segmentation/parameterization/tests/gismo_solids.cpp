#include "segmentation/parameterization/tests/gismo_solids.hpp"

#include <memory>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation::test {
namespace {

using geometry::KnotVector;

template <class T>
std::vector<T> numbers(const pugi::xml_node& node) {
  std::istringstream text(node.child_value());
  std::vector<T> result;
  for (T x; text >> x;) result.push_back(x);
  return result;
}

/// Degree and knots as the file has them: inner knots may be repeated degree + 1 times, with equal control
/// points.
struct RawKnots {
  int degree = 1;
  std::vector<double> knots;
  int size() const { return static_cast<int>(knots.size()) - degree - 1; }
};

RawKnots knots_of(const pugi::xml_node& basis) {
  const pugi::xml_node knots = basis.child("KnotVector");
  return {knots.attribute("degree").as_int(), numbers<double>(knots)};
}

/// Drops the knots and control points that are one too many.
/// @param inner  columns between the direction's entries
Eigen::Matrix3Xd without_repetitions(RawKnots& raw, Eigen::Matrix3Xd points, int inner) {
  const auto p = static_cast<std::size_t>(raw.degree);
  for (std::size_t i = p + 1; i + 2 * p + 1 < raw.knots.size(); ++i) {
    if (raw.knots[i] != raw.knots[i + p]) continue;
    // The control points i - 1 and i are the end of one piece and the start of the next.
    const int n = raw.size();
    std::vector<Eigen::Index> kept;
    for (Eigen::Index c = 0; c < points.cols(); ++c)
      if (c / inner % n != static_cast<Eigen::Index>(i)) kept.push_back(c);
    points = Eigen::Matrix3Xd(points(Eigen::all, kept));
    raw.knots.erase(raw.knots.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return points;
}

Eigen::Matrix3Xd points_of(const pugi::xml_node& geometry) {
  const pugi::xml_node coefs = geometry.child("coefs");
  const int dimension = coefs.attribute("geoDim").as_int();
  const std::vector<double> all = numbers<double>(coefs);
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(all.size()) / dimension);
  for (std::size_t i = 0; i < all.size(); ++i)
    points(static_cast<Eigen::Index>(i) % dimension, static_cast<Eigen::Index>(i) / dimension) = all[i];
  return points;
}

PlainFace face_of(const pugi::xml_node& node) {
  PlainFace face;
  const pugi::xml_node geometry = node.child("Geometry");
  std::vector<RawKnots> knots;
  for (const auto& basis : geometry.child("Basis").children("Basis")) knots.push_back(knots_of(basis));
  Eigen::Matrix3Xd points = without_repetitions(knots[0], points_of(geometry), 1);
  points = without_repetitions(knots[1], points, knots[0].size());
  const auto surface = std::make_shared<const geometry::NurbsSurface>(
      geometry::NurbsSurface::KnotVectors{KnotVector(knots[0].degree, knots[0].knots),
                                          KnotVector(knots[1].degree, knots[1].knots)},
      points);
  // Beyond its knots the surface runs on straight, so that faces that end short of each other still meet.
  face.surface = [surface](const Eigen::Vector2d& uv) -> Eigen::Vector3d {
    const Eigen::Vector2d inside = uv.cwiseMax(surface->low()).cwiseMin(surface->high());
    if (inside == uv) return surface->point(uv);
    return surface->point(inside) + surface->jacobian(inside) * (uv - inside);
  };
  for (const auto& curve : node.child("PlanarDomain").child("CurveLoop").children("Geometry")) {
    RawKnots raw = knots_of(curve.child("Basis"));
    const Eigen::Matrix3Xd curve_points = without_repetitions(raw, points_of(curve), 1);
    const auto spline = std::make_shared<const geometry::NurbsCurve>(
        geometry::NurbsCurve::KnotVectors{KnotVector(raw.degree, raw.knots)}, curve_points);
    const double low = spline->low()[0], length = spline->high()[0] - low;
    face.curves.push_back([=](double t) -> Eigen::Vector2d {
      return spline->point(geometry::Parameter<1>(low + t * length)).head<2>();
    });
  }
  return face;
}

}  // namespace

std::vector<PlainFace> gismo_faces(const std::string& path) {
  pugi::xml_document document;
  if (!document.load_file(path.c_str())) throw std::runtime_error("cannot read " + path);
  const pugi::xml_node root = document.child("xml");
  std::vector<PlainFace> surfaces, result;
  for (const auto& node : root.children("TrimSurface")) surfaces.push_back(face_of(node));
  const auto faces = numbers<int>(root.child("Solid").child("Face"));
  for (std::size_t i = 0; i < faces.size();) {
    const auto count = static_cast<std::size_t>(faces[i]);
    result.push_back(surfaces.at(static_cast<std::size_t>(faces.at(i + count + 1))));
    i += count + 2;
  }
  return result;
}

}  // namespace isopatch::segmentation::test
