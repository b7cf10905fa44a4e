#include "geometry/brep/opencascade/internal/face_surface.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <cmath>
#include <numbers>

#include "geometry/brep/opencascade/internal/conversions.hpp"

namespace isopatch::geometry {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

/// A freeform surface; parameters are those of the nearest point.
class SplineSurface : public FaceSurface {
 public:
  SplineSurface(const NurbsSurface& spline, double scale) : surface_(to_shape(spline, scale)) {
    surface_->Bounds(low_.x(), high_.x(), low_.y(), high_.y());
  }
  Handle(Geom_Surface) surface() const override { return Handle(Geom_Surface)(surface_); }

  Eigen::Vector2d parameters(const Eigen::Vector3d& point,
                             const std::optional<Eigen::Vector2d>& before) const override {
    return nearest(point, before ? *before : nearest_of_grid(point));
  }

 private:
  Eigen::Vector2d nearest_of_grid(const Eigen::Vector3d& point) const {
    constexpr int places = 48;
    Eigen::Vector2d best = low_;
    double least = 1e300;
    for (int i = 0; i <= places; ++i)
      for (int j = 0; j <= places; ++j) {
        const Eigen::Vector2d uv = low_ + (high_ - low_).cwiseProduct(Eigen::Vector2d(i, j) / places);
        const double off = (to_eigen(surface_->Value(uv.x(), uv.y())) - point).squaredNorm();
        if (!(off < least)) continue;
        least = off;
        best = uv;
      }
    return best;
  }

  /// Gauss-Newton steps within the domain.
  Eigen::Vector2d nearest(const Eigen::Vector3d& point, Eigen::Vector2d uv) const {
    for (int round = 0; round < 40; ++round) {
      gp_Pnt there;
      gp_Vec by_u, by_v;
      surface_->D1(uv.x(), uv.y(), there, by_u, by_v);
      Eigen::Matrix<double, 3, 2> slopes;
      slopes << to_eigen(by_u), to_eigen(by_v);
      const Eigen::Vector3d way = point - to_eigen(there);
      const Eigen::Matrix2d matrix = slopes.transpose() * slopes;
      Eigen::Vector2d step = matrix.ldlt().solve(slopes.transpose() * way);
      // Held at a border, only the other parameter is free.
      for (Eigen::Index i = 0; i < 2; ++i)
        if ((uv[i] == low_[i] && step[i] < 0) || (uv[i] == high_[i] && step[i] > 0)) {
          step[i] = 0;
          step[1 - i] = slopes.col(1 - i).dot(way) / matrix(1 - i, 1 - i);
        }
      Eigen::Vector2d next = (uv + step).cwiseMax(low_).cwiseMin(high_);
      // Where the surface bends away, the whole step leads too far.
      const auto off = [&](const Eigen::Vector2d& at) {
        return (to_eigen(surface_->Value(at.x(), at.y())) - point).norm();
      };
      for (int half = 0; half < 4 && off(next) > way.norm(); ++half)
        next = (uv + (step *= 0.5)).cwiseMax(low_).cwiseMin(high_);
      const bool done = (next - uv).norm() < 1e-14 * (high_ - low_).norm();
      uv = next;
      if (done) break;
    }
    return uv;
  }

  Handle(Geom_BSplineSurface) surface_;
  Eigen::Vector2d low_, high_;
};

/// A carrier as a surface.
class CarrierSurface : public FaceSurface {
 public:
  /// @param start  a point of the seam, where the turn begins; on the axis: anywhere
  CarrierSurface(const Carrier& carrier, const Eigen::Vector3d& start, double scale) : carrier_(carrier) {
    carrier_.origin *= scale;
    carrier_.radius *= scale;
    carrier_.second_radius *= scale;
    z_ = carrier_.axis;
    const Eigen::Vector3d way = scale * start - carrier_.origin;
    x_ = way - z_ * z_.dot(way);
    if (!(x_.norm() > 1e-9 * (1 + way.norm())))
      x_ = to_eigen(gp_Ax2(gp_Pnt(), gp_Dir(z_.x(), z_.y(), z_.z())).XDirection());
    x_.normalize();
    y_ = z_.cross(x_);
    const gp_Ax3 frame(to_point(carrier_.origin), gp_Dir(z_.x(), z_.y(), z_.z()),
                       gp_Dir(x_.x(), x_.y(), x_.z()));
    switch (carrier_.kind) {
      case SurfaceKind::cylinder:
        surface_ = new Geom_CylindricalSurface(frame, carrier_.radius);
        break;
      case SurfaceKind::cone:
        surface_ = new Geom_ConicalSurface(frame, carrier_.half_angle.radians(), carrier_.radius);
        break;
      case SurfaceKind::sphere:
        surface_ = new Geom_SphericalSurface(frame, carrier_.radius);
        break;
      case SurfaceKind::torus:
        surface_ = new Geom_ToroidalSurface(frame, carrier_.radius, carrier_.second_radius);
        break;
      default:
        surface_ = new Geom_Plane(frame);
    }
  }
  Handle(Geom_Surface) surface() const override { return Handle(Geom_Surface)(surface_); }
  double u_period() const override { return carrier_.kind == SurfaceKind::plane ? 0 : whole_turn; }
  double v_period() const override { return carrier_.kind == SurfaceKind::torus ? turn : 0; }

  Eigen::Vector2d parameters(const Eigen::Vector3d& point,
                             const std::optional<Eigen::Vector2d>& known) const override {
    const Eigen::Vector2d before = known.value_or(Eigen::Vector2d::Zero());
    const Eigen::Vector3d way = point - carrier_.origin;
    const double a = x_.dot(way), b = y_.dot(way), h = z_.dot(way), r = std::hypot(a, b);
    if (carrier_.kind == SurfaceKind::plane) return {a, b};
    // On the cone's other half the turn is the opposite one.
    Eigen::Vector2d uv(std::atan2(b, a), h);
    switch (carrier_.kind) {
      case SurfaceKind::cone: {
        const double angle = carrier_.half_angle.radians();
        uv.y() = (r - carrier_.radius) * std::sin(angle) + h * std::cos(angle);
        break;
      }
      case SurfaceKind::sphere:
        uv.y() = std::atan2(h, r);
        break;
      case SurfaceKind::torus:
        uv.y() = std::atan2(h, r - carrier_.radius);
        break;
      default:
        break;
    }
    if (r < 1e-9 * (1 + way.norm())) uv.x() = before.x();
    uv.x() += whole_turn * std::round((before.x() - uv.x()) / whole_turn);
    if (v_period() > 0) uv.y() += whole_turn * std::round((before.y() - uv.y()) / whole_turn);
    return uv;
  }

 private:
  Carrier carrier_;
  Eigen::Vector3d x_, y_, z_;
  Handle(Geom_Surface) surface_;
};

}  // namespace

std::unique_ptr<FaceSurface> carrier_surface(const Carrier& carrier, const Eigen::Vector3d& start,
                                             double scale) {
  return std::make_unique<CarrierSurface>(carrier, start, scale);
}

std::unique_ptr<FaceSurface> spline_surface(const NurbsSurface& spline, double scale) {
  return std::make_unique<SplineSurface>(spline, scale);
}

}  // namespace isopatch::geometry
