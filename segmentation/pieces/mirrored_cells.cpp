#include "segmentation/pieces/mirrored_cells.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/cut_by_plane.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/pieces/joined_complex.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::NurbsCurve;
using geometry::NurbsSurface;
using geometry::PlaneSurface;

/// Of points and of what is made of them.
class Mirror {
 public:
  explicit Mirror(const PlaneSurface& plane) : origin_(plane.origin), normal_(plane.normal()) {}

  Eigen::Vector3d direction(const Eigen::Vector3d& v) const { return v - 2 * v.dot(normal_) * normal_; }
  Eigen::Vector3d point(const Eigen::Vector3d& p) const { return origin_ + direction(p - origin_); }
  double height(const Eigen::Vector3d& p) const { return (p - origin_).dot(normal_); }

  Eigen::Matrix3Xd points(Eigen::Matrix3Xd of) const {
    for (auto column : of.colwise()) column = point(column);
    return of;
  }
  NurbsCurve curve(const NurbsCurve& of) const {
    return NurbsCurve(of.knots(), points(of.control_points()), of.weights());
  }
  /// Its u runs the other way, so that its normal is the image of the normal.
  geometry::CellSurface surface(const geometry::CellSurface& of) const {
    if (const auto* plane = std::get_if<PlaneSurface>(&of))
      return PlaneSurface{point(plane->origin), -direction(plane->x), direction(plane->y)};
    const NurbsSurface& spline = std::get<NurbsSurface>(of);
    return geometry::reversed(NurbsSurface(spline.knots(), points(spline.control_points()), spline.weights()),
                              0);
  }

 private:
  Eigen::Vector3d origin_, normal_;
};

/// In the domain of a surface whose u runs the other way.
NurbsCurve turned(const NurbsCurve& trace, const NurbsSurface& surface) {
  Eigen::Matrix3Xd points = trace.control_points();
  points.row(0) = (surface.low()[0] + surface.high()[0] - points.row(0).array()).matrix();
  return NurbsCurve(trace.knots(), points, trace.weights());
}

CellComplex image_of(const CellComplex& complex, const Mirror& mirror) {
  CellComplex result = complex;
  for (Eigen::Vector3d& vertex : result.vertices) vertex = mirror.point(vertex);
  for (geometry::CellCurve& curve : result.curves) {
    curve.shape = mirror.curve(std::get<NurbsCurve>(curve.shape));
    for (geometry::CellCurve::Trace& trace : curve.traces)
      trace.domain = turned(trace.domain, std::get<NurbsSurface>(complex.surface(trace.surface)));
  }
  for (geometry::CellSurface& surface : result.surfaces) surface = mirror.surface(surface);
  for (geometry::CellFace& face : result.faces) {
    std::reverse(face.loop.begin(), face.loop.end());
    for (geometry::EdgeUse& use : face.loop) use.reversed = !use.reversed;
  }
  return result;
}

/// Inside a face of a complex: of a plane one near the middle of its corners.
Eigen::Vector3d middle_of(const CellComplex& complex, const geometry::CellFace& face) {
  if (const auto* spline = std::get_if<NurbsSurface>(&complex.surface(face.surface)))
    return spline->point((spline->low() + spline->high()) / 2);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const geometry::EdgeUse& use : face.loop) {
    const NurbsCurve& curve = std::get<NurbsCurve>(complex.curve(complex.edge(use.edge).curve).shape);
    sum += curve.point((curve.low() + curve.high()) / 2);
  }
  return sum / static_cast<double>(face.loop.size());
}

/// The face of the solid at a point.
std::optional<FaceId> face_at(const Brep& solid, const Eigen::Vector3d& point) {
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f) {
    const geometry::FaceProjection nearest = solid.project(FaceId(f), point);
    if (nearest.distance < 1e-6 * solid.size() && solid.contains(FaceId(f), nearest.uv)) return FaceId(f);
  }
  return std::nullopt;
}

/// By face of a half: that of the solid on which its image lies, as far as it has cells.
std::vector<std::optional<FaceId>> faces_of_image(const Brep& solid, const CellComplex& complex,
                                                  const std::vector<std::optional<FaceId>>& origin,
                                                  const Mirror& mirror) {
  std::vector<std::optional<FaceId>> result(origin.size());
  for (const geometry::CellFace& face : complex.faces) {
    if (!face.origin) continue;
    const auto number = static_cast<std::size_t>(face.origin->value);
    if (!origin[number] || result[number]) continue;
    result[number] = face_at(solid, mirror.point(middle_of(complex, face)));
    if (!result[number])
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("it is not symmetric about the plane: nothing is opposite to {}",
                              describe(solid, *origin[number])));
  }
  return result;
}

/// On the side to which the normal points.
bool is_above(const Brep& part, const Mirror& mirror) {
  double farthest = 0;
  for (const auto vertex : part.vertices().colwise())
    if (const double height = mirror.height(vertex); std::abs(height) > std::abs(farthest)) farthest = height;
  return farthest > 0;
}

}  // namespace

CellComplex mirrored_cells(const Brep& solid, const PlaneSurface& plane,
                           const std::function<CellComplex(const Brep& half)>& cells_of) {
  const Mirror mirror(plane);
  const std::vector<geometry::CutPart> parts = geometry::cut_by_plane(solid, plane.origin, plane.normal());
  double above = 0;
  for (const geometry::CutPart& part : parts)
    if (is_above(part.brep, mirror)) above += part.brep.volume();
  if (parts.size() < 2 || std::abs(2 * above - solid.volume()) > 1e-6 * solid.volume())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("it is not symmetric about the plane: {:.4g} % of its volume are on one side",
                            100 * above / solid.volume()));
  std::vector<ComplexOfPiece> pieces;
  for (const geometry::CutPart& part : parts) {
    if (!is_above(part.brep, mirror)) continue;
    ComplexOfPiece half{cells_of(part.brep), part.origin};
    pieces.push_back(
        {image_of(half.complex, mirror), faces_of_image(solid, half.complex, part.origin, mirror)});
    pieces.push_back(std::move(half));
  }
  return joined_complex(pieces, 1e-6 * solid.size());
}

}  // namespace isopatch::segmentation
