#include "segmentation/parameterization/internal/brep_splines.hpp"

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/brep/make_brep.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CurveKind;
using geometry::SurfaceKind;

/// Round-off of two evaluations, of the solid's size.
constexpr double same_point = 1e-11;

bool is_same_curve(const Brep& brep, EdgeId edge, const geometry::NurbsCurve& curve) {
  const double low = curve.low()[0], length = curve.high()[0] - low;
  for (const double t : {0.0, 0.13, 0.37, 0.5, 0.71, 0.93, 1.0})
    if ((curve.point(geometry::Parameter<1>(low + t * length)) - brep.point(edge, t)).norm() >
        same_point * brep.size())
      return false;
  return true;
}

bool is_same_surface(const Brep& brep, FaceId face, const geometry::NurbsSurface& surface) {
  const geometry::DomainBox box = brep.domain(face);
  for (const double s : {0.0, 0.17, 0.5, 0.83, 1.0})
    for (const double t : {0.0, 0.29, 0.61, 1.0}) {
      const Eigen::Vector2d uv = box.low + Eigen::Vector2d(s, t).cwiseProduct(box.high - box.low);
      if ((surface.point(uv) - brep.point(face, uv)).norm() > same_point * brep.size()) return false;
    }
  return true;
}

bool may_be_polynomial(SurfaceKind kind) {
  return kind == SurfaceKind::spline || kind == SurfaceKind::other;
}

}  // namespace

std::optional<geometry::KnotVector> spline_knots(const Brep& brep, EdgeId edge) {
  const CurveKind kind = brep.edge(edge).kind;
  if (kind != CurveKind::spline && kind != CurveKind::other) return std::nullopt;
  try {
    const geometry::NurbsCurve curve = brep.curve(edge);
    if (curve.is_rational() || !is_same_curve(brep, edge, curve)) return std::nullopt;
    return rescaled(curve.knots(0), 0, 1);
  } catch (const Error&) {  // no rational form: nothing to keep
    return std::nullopt;
  }
}

std::vector<std::optional<SplineSurfaceKnots>> spline_knots(const Brep& brep) {
  std::vector<std::optional<SplineSurfaceKnots>> result(brep.faces().size());
  if (std::none_of(brep.faces().begin(), brep.faces().end(),
                   [](const auto& face) { return may_be_polynomial(face.kind); }))
    return result;
  std::vector<geometry::TrimmedSurface> surfaces;
  try {
    surfaces = trimmed_surfaces(brep);
  } catch (const Error&) {  // some face has no rational form
    return result;
  }
  for (std::size_t f = 0; f < surfaces.size(); ++f) {
    const geometry::NurbsSurface& surface = surfaces[f].surface;
    const FaceId id(static_cast<int>(f));
    if (may_be_polynomial(brep.face(id).kind) && !surface.is_rational() && is_same_surface(brep, id, surface))
      result[f] = SplineSurfaceKnots{surface.knots()};
  }
  return result;
}

}  // namespace isopatch::segmentation
