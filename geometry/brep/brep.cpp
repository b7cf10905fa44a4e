#include "geometry/brep/brep.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/kernel.hpp"

namespace isopatch::geometry {
namespace {

template <class Tag>
void require(Id<Tag> id, std::size_t count, const char* what, const char* what_many) {
  if (id.value < 0 || static_cast<std::size_t>(id.value) >= count)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("there is no {} {}; the solid has {} {}", what, id.value, count, what_many));
}

const BrepKernel& checked(const std::shared_ptr<const BrepKernel>& kernel, FaceId face) {
  require(face, kernel->tables().faces.size(), "face", "faces");
  return *kernel;
}

const BrepKernel& checked(const std::shared_ptr<const BrepKernel>& kernel, EdgeId edge) {
  require(edge, kernel->tables().edges.size(), "edge", "edges");
  return *kernel;
}

template <class T>
T required(const std::optional<T>& value, FaceId face, EdgeUse use) {
  if (value) return *value;
  throw Error(ErrorCode::invalid_argument,
              fmt::format("face {} does not use edge {} {}", face.value, use.edge.value,
                          use.reversed ? "reversed" : "forwards"));
}

// S_u x S_v, or nothing where it vanishes.
std::optional<Eigen::Vector3d> cross_normal(const Eigen::Matrix<double, 3, 2>& d) {
  const Eigen::Vector3d u = d.col(0), v = d.col(1);
  const Eigen::Vector3d normal = u.cross(v);
  const double length = normal.norm();
  const double scale = std::max(u.squaredNorm(), v.squaredNorm());
  if (!(length > 1e-9 * scale)) return std::nullopt;
  return normal / length;
}

}  // namespace

std::string hex_text(const Colour& colour) {
  const auto byte = [](double x) { return static_cast<int>(std::clamp(x, 0.0, 1.0) * 255 + 0.5); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]), byte(colour[2]));
}

const char* name(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::plane:
      return "plane";
    case SurfaceKind::cylinder:
      return "cylinder";
    case SurfaceKind::cone:
      return "cone";
    case SurfaceKind::sphere:
      return "sphere";
    case SurfaceKind::torus:
      return "torus";
    case SurfaceKind::spline:
      return "spline";
    case SurfaceKind::other:
      break;
  }
  return "other";
}

const char* name(CurveKind kind) {
  switch (kind) {
    case CurveKind::line:
      return "line";
    case CurveKind::circle:
      return "circle";
    case CurveKind::ellipse:
      return "ellipse";
    case CurveKind::spline:
      return "spline";
    case CurveKind::other:
      break;
  }
  return "other";
}

Brep::Brep(std::shared_ptr<const BrepKernel> kernel) : kernel_(std::move(kernel)) {
  if (!kernel_) throw Error(ErrorCode::invalid_argument, "a solid needs a kernel");
}

const std::vector<BrepFace>& Brep::faces() const {
  return kernel_->tables().faces;
}
const std::vector<BrepEdge>& Brep::edges() const {
  return kernel_->tables().edges;
}
const Eigen::Matrix3Xd& Brep::vertices() const {
  return kernel_->tables().vertices;
}

const BrepFace& Brep::face(FaceId face) const {
  return checked(kernel_, face).tables().faces[static_cast<std::size_t>(face.value)];
}
const BrepEdge& Brep::edge(EdgeId edge) const {
  return checked(kernel_, edge).tables().edges[static_cast<std::size_t>(edge.value)];
}
Eigen::Vector3d Brep::vertex(VertexId vertex) const {
  require(vertex, static_cast<std::size_t>(vertices().cols()), "vertex", "vertices");
  return vertices().col(vertex.value);
}

double Brep::size() const {
  return (box()[1] - box()[0]).norm();
}
std::array<Eigen::Vector3d, 2> Brep::box() const {
  return kernel_->tables().box;
}
Measure Brep::measured_volume() const {
  return kernel_->volume();
}
Measure Brep::measured_area(FaceId face) const {
  return checked(kernel_, face).area(face);
}
Measure Brep::measured_area() const {
  Measure sum;
  for (std::size_t i = 0; i < faces().size(); ++i) {
    const Measure area = kernel_->area(FaceId(static_cast<int>(i)));
    sum.value += area.value;
    sum.error += area.error;
  }
  return sum;
}

Eigen::Vector3d Brep::point(EdgeId edge, double t) const {
  return checked(kernel_, edge).point(edge, t);
}
Eigen::Vector3d Brep::tangent(EdgeId edge, double t) const {
  return checked(kernel_, edge).tangent(edge, t);
}
EdgeProjection Brep::project(EdgeId edge, const Eigen::Vector3d& point) const {
  return checked(kernel_, edge).project(edge, point);
}
NurbsCurve Brep::curve(EdgeId edge) const {
  return checked(kernel_, edge).curve(edge);
}

DomainBox Brep::domain(FaceId face) const {
  return checked(kernel_, face).domain(face);
}
Eigen::Vector2d Brep::domain_point(FaceId face, EdgeUse use, double t) const {
  return required(checked(kernel_, face).domain_point(face, use, t), face, use);
}
Eigen::Vector2d Brep::domain_tangent(FaceId face, EdgeUse use, double t) const {
  return required(checked(kernel_, face).domain_tangent(face, use, t), face, use);
}
Eigen::Vector3d Brep::point(FaceId face, const Eigen::Vector2d& uv) const {
  return checked(kernel_, face).point(face, uv);
}
Eigen::Matrix<double, 3, 2> Brep::derivatives(FaceId face, const Eigen::Vector2d& uv) const {
  return checked(kernel_, face).derivatives(face, uv);
}
Eigen::Matrix3d Brep::second_derivatives(FaceId face, const Eigen::Vector2d& uv) const {
  return checked(kernel_, face).second_derivatives(face, uv);
}

Eigen::Vector3d Brep::outward_normal(FaceId face, const Eigen::Vector2d& uv) const {
  const double sign = this->face(face).reversed ? -1 : 1;
  const DomainBox box = domain(face);
  const Eigen::Vector2d middle = (box.low + box.high) / 2;
  // Steps towards the middle leave a pole along a meridian.
  for (double step = 0; step < 0.1; step = step == 0 ? 1e-7 : 10 * step)
    if (const auto normal = cross_normal(derivatives(face, uv + step * (middle - uv)))) return sign * *normal;
  throw Error(ErrorCode::unsupported,
              fmt::format("face {} has no normal near ({}, {}) of its domain", face.value, uv.x(), uv.y()));
}

FaceProjection Brep::project(FaceId face, const Eigen::Vector3d& point) const {
  return checked(kernel_, face).project(face, point);
}
FaceProjection Brep::project(FaceId face, const Eigen::Vector3d& point, const Eigen::Vector2d& start) const {
  return checked(kernel_, face).project(face, point, start);
}
bool Brep::contains(FaceId face, const Eigen::Vector2d& uv) const {
  return checked(kernel_, face).contains(face, uv);
}
std::optional<Carrier> Brep::carrier(FaceId face) const {
  return checked(kernel_, face).carrier(face);
}

Tessellation tessellate(const Brep& brep, const TessellationOptions& options) {
  if (!(options.chord > 0 && options.chord < 0.1))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("chord is {}; it must lie in (0, 0.1)", options.chord));
  if (!(options.turn > Angle() && options.turn <= Angle::degrees(90)))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("turn is {} degrees; it must lie in (0, 90]", options.turn.degrees()));
  return brep.kernel().tessellate(options);
}

}  // namespace isopatch::geometry
