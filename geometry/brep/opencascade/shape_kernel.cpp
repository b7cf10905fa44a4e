#include "geometry/brep/opencascade/internal/shape_kernel.hpp"

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/face_measure.hpp"
#include "geometry/brep/opencascade/internal/nearest_point.hpp"
#include "geometry/brep/opencascade/internal/shape_tables.hpp"
#include "geometry/brep/opencascade/internal/tessellation.hpp"

namespace isopatch::geometry {
namespace {

double parameter(const EdgeGeometry& edge, double t) {
  return edge.first + (edge.last - edge.first) * t;
}
double parameter(const UseCurve& use, double t) {
  return use.first + (use.last - use.first) * t;
}

void set_axis(Carrier& carrier, const gp_Ax3& position, double metres) {
  carrier.origin = metres * to_eigen(position.Location());
  carrier.axis = to_eigen(position.Direction());
}

/// Three times the volume, in units of the shape.
struct VolumeSum {
  Measure flux;
  double quadrature_error = 0;  // of its error, what a finer quadrature makes smaller
};

VolumeSum volume_of(const std::vector<FaceMeasure>& measures, const std::vector<BrepFace>& faces) {
  VolumeSum sum;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Measure& flux = measures[i].flux;
    sum.flux.value += faces[i].reversed ? -flux.value : flux.value;
    sum.flux.error += flux.error;
    sum.quadrature_error += flux.error - measures[i].open_flux;
  }
  return sum;
}

}  // namespace

struct ShapeKernel::Lazy {
  struct OfFace {
    std::once_flag grid_once, measure_once;
    SurfaceGrid grid;
    FaceMeasure measure;
    std::mutex classifier_lock;
    std::unique_ptr<BRepTopAdaptor_FClass2d> classifier;
  };
  explicit Lazy(std::size_t count) : faces(count) {}
  std::vector<OfFace> faces;
  std::once_flag volume_once;
  Measure volume;
};

ShapeKernel::ShapeKernel(ShapeInput input) : input_(std::move(input)) {
  ShapeTables made = shape_tables(input_);
  tables_ = std::move(made.tables);
  faces_ = std::move(made.faces);
  edges_ = std::move(made.edges);
  lazy_ = std::make_unique<Lazy>(faces_.size());
}

ShapeKernel::~ShapeKernel() = default;

FaceMeasureOptions ShapeKernel::measure_options() const {
  const auto& [low, high] = tables_.box;
  FaceMeasureOptions options;
  options.reference = (low + high) / 2 / input_.metres;
  options.size = (high - low).norm() / input_.metres;
  return options;
}

const FaceMeasure& ShapeKernel::measure(std::size_t face) const {
  Lazy::OfFace& lazy = lazy_->faces[face];
  std::call_once(lazy.measure_once, [&] {
    lazy.measure = measure_face(faces_[face].face, faces_[face].surface, measure_options());
  });
  return lazy.measure;
}

// Thin walls are small differences of large contributions: where the usual accuracy is not enough for them,
// what is. Round-off ends at about 1e-14.
Measure ShapeKernel::volume() const {
  std::call_once(lazy_->volume_once, [&] {
    std::vector<FaceMeasure> measures;
    for (std::size_t i = 0; i < faces_.size(); ++i) measures.push_back(measure(i));
    VolumeSum sum = volume_of(measures, tables_.faces);
    const double missing = Measure::promised * std::abs(sum.flux.value) / sum.quadrature_error;
    if (missing < 1 && std::isfinite(sum.flux.error)) {
      FaceMeasureOptions options = measure_options();
      options.relative = std::max(1e-14, 0.1 * missing * options.relative);
      for (std::size_t i = 0; i < faces_.size(); ++i)
        measures[i] = measure_face(faces_[i].face, faces_[i].surface, options);
      sum = volume_of(measures, tables_.faces);
    }
    const double third = std::pow(input_.metres, 3) / 3;
    lazy_->volume = {third * sum.flux.value, third * sum.flux.error};
  });
  return lazy_->volume;
}

Measure ShapeKernel::area(FaceId face) const {
  const Measure& area = measure(static_cast<std::size_t>(face.value)).area;
  const double square = std::pow(input_.metres, 2);
  return {square * area.value, square * area.error};
}

Eigen::Vector3d ShapeKernel::point(EdgeId edge, double t) const {
  return input_.metres * to_eigen(of(edge).curve->Value(parameter(of(edge), t)));
}

Eigen::Vector3d ShapeKernel::tangent(EdgeId edge, double t) const {
  gp_Pnt p;
  gp_Vec d;
  of(edge).curve->D1(parameter(of(edge), t), p, d);
  return input_.metres * (of(edge).last - of(edge).first) * to_eigen(d);
}

EdgeProjection ShapeKernel::project(EdgeId edge, const Eigen::Vector3d& target) const {
  const EdgeGeometry& geometry = of(edge);
  const double found =
      nearest_parameter(*geometry.curve, geometry.first, geometry.last, target / input_.metres);
  const double t = (found - geometry.first) / (geometry.last - geometry.first);
  const Eigen::Vector3d at = point(edge, t);
  return {t, at, (at - target).norm()};
}

NurbsCurve ShapeKernel::curve(EdgeId edge) const {
  const EdgeGeometry& geometry = of(edge);
  try {
    const Handle(Geom_TrimmedCurve) piece =
        new Geom_TrimmedCurve(geometry.curve, geometry.first, geometry.last);
    const Handle(Geom_BSplineCurve) spline = GeomConvert::CurveToBSplineCurve(piece);
    if (spline->IsPeriodic()) spline->SetNotPeriodic();
    return to_nurbs(*spline, input_.metres);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::unsupported,
                fmt::format("edge {} has no exact NURBS form: {}", edge.value, failure.GetMessageString()));
  }
}

DomainBox ShapeKernel::domain(FaceId face) const {
  return of(face).domain;
}

std::optional<Eigen::Vector2d> ShapeKernel::domain_point(FaceId face, EdgeUse use, double t) const {
  const auto found = of(face).uses.find(use);
  if (found == of(face).uses.end()) return std::nullopt;
  return to_eigen(found->second.curve->Value(parameter(found->second, t)));
}

std::optional<Eigen::Vector2d> ShapeKernel::domain_tangent(FaceId face, EdgeUse use, double t) const {
  const auto found = of(face).uses.find(use);
  if (found == of(face).uses.end()) return std::nullopt;
  gp_Pnt2d p;
  gp_Vec2d d;
  found->second.curve->D1(parameter(found->second, t), p, d);
  return (found->second.last - found->second.first) * Eigen::Vector2d(d.X(), d.Y());
}

Eigen::Vector3d ShapeKernel::point(FaceId face, const Eigen::Vector2d& uv) const {
  return input_.metres * to_eigen(of(face).surface->Value(uv.x(), uv.y()));
}

Eigen::Matrix<double, 3, 2> ShapeKernel::derivatives(FaceId face, const Eigen::Vector2d& uv) const {
  gp_Pnt p;
  gp_Vec u, v;
  of(face).surface->D1(uv.x(), uv.y(), p, u, v);
  Eigen::Matrix<double, 3, 2> result;
  result << input_.metres * to_eigen(u), input_.metres * to_eigen(v);
  return result;
}

Eigen::Matrix3d ShapeKernel::second_derivatives(FaceId face, const Eigen::Vector2d& uv_) const {
  gp_Pnt p;
  gp_Vec u, v, uu, vv, uv;
  of(face).surface->D2(uv_.x(), uv_.y(), p, u, v, uu, vv, uv);
  Eigen::Matrix3d result;
  result << to_eigen(uu), to_eigen(uv), to_eigen(vv);
  return input_.metres * result;
}

FaceProjection ShapeKernel::project(FaceId face, const Eigen::Vector3d& target) const {
  const FaceGeometry& geometry = of(face);
  Lazy::OfFace& lazy = lazy_->faces[static_cast<std::size_t>(face.value)];
  std::call_once(lazy.grid_once, [&] { lazy.grid = surface_grid(*geometry.surface, geometry.domain); });
  const SurfacePoint found =
      nearest_point(*geometry.surface, geometry.domain, lazy.grid, target / input_.metres);
  return {found.uv, input_.metres * found.point, input_.metres * found.distance};
}

FaceProjection ShapeKernel::project(FaceId face, const Eigen::Vector3d& target,
                                    const Eigen::Vector2d& start) const {
  const FaceGeometry& geometry = of(face);
  const SurfaceDescent near = descend(*geometry.surface, geometry.domain, start, target / input_.metres);
  if (!near.converged) return project(face, target);
  return {near.found.uv, input_.metres * near.found.point, input_.metres * near.found.distance};
}

bool ShapeKernel::contains(FaceId face, const Eigen::Vector2d& uv) const {
  Lazy::OfFace& lazy = lazy_->faces[static_cast<std::size_t>(face.value)];
  const std::lock_guard<std::mutex> lock(lazy.classifier_lock);
  if (!lazy.classifier)
    lazy.classifier =
        std::make_unique<BRepTopAdaptor_FClass2d>(of(face).face, BRep_Tool::Tolerance(of(face).face));
  const TopAbs_State state = lazy.classifier->Perform(gp_Pnt2d(uv.x(), uv.y()));
  return state == TopAbs_IN || state == TopAbs_ON;
}

std::optional<Carrier> ShapeKernel::carrier(FaceId face) const {
  Handle(Geom_Surface) surface = of(face).surface;
  if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !trimmed.IsNull())
    surface = trimmed->BasisSurface();
  const double metres = input_.metres;
  Carrier result;
  result.kind = tables_.faces[static_cast<std::size_t>(face.value)].kind;
  if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull()) {
    set_axis(result, plane->Position(), metres);
  } else if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull()) {
    set_axis(result, cylinder->Position(), metres);
    result.radius = metres * cylinder->Radius();
  } else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) {
    set_axis(result, cone->Position(), metres);
    result.radius = metres * cone->RefRadius();
    result.half_angle = Angle::radians(cone->SemiAngle());
  } else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull()) {
    set_axis(result, sphere->Position(), metres);
    result.radius = metres * sphere->Radius();
  } else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface); !torus.IsNull()) {
    set_axis(result, torus->Position(), metres);
    result.radius = metres * torus->MajorRadius();
    result.second_radius = metres * torus->MinorRadius();
  } else {
    return std::nullopt;
  }
  return result;
}

Tessellation ShapeKernel::tessellate(const TessellationOptions& options) const {
  const double size = (tables_.box[1] - tables_.box[0]).norm();
  return tessellate_shape(input_, faces_, edges_, options.chord * size / input_.metres,
                          options.turn.radians());
}

}  // namespace isopatch::geometry
