#include "geometry/brep/opencascade/internal/nearest_point.hpp"

#include <Eigen/LU>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/brep/opencascade/internal/conversions.hpp"

namespace isopatch::geometry {
namespace {

struct Jet {
  Eigen::Vector3d point, u, v, uu, uv, vv;
};

Jet jet(const Geom_Surface& surface, const Eigen::Vector2d& at) {
  gp_Pnt p;
  gp_Vec u, v, uu, vv, uv;
  surface.D2(at.x(), at.y(), p, u, v, uu, vv, uv);
  return {to_eigen(p), to_eigen(u), to_eigen(v), to_eigen(uu), to_eigen(uv), to_eigen(vv)};
}

Eigen::Vector2d clamped(const Eigen::Vector2d& uv, const DomainBox& box) {
  return uv.cwiseMax(box.low).cwiseMin(box.high);
}

// Descent direction of |S - target|^2 / 2 with the coordinates kept that the box holds back. Newton's where
// the Hessian is positive, else Gauss's.
Eigen::Vector2d step(const Jet& j, const Eigen::Vector3d& target, const Eigen::Vector2d& at,
                     const DomainBox& box) {
  const Eigen::Vector3d r = j.point - target;
  const Eigen::Vector2d gradient(r.dot(j.u), r.dot(j.v));
  Eigen::Matrix2d gauss;
  gauss << j.u.dot(j.u), j.u.dot(j.v), j.u.dot(j.v), j.v.dot(j.v);
  Eigen::Matrix2d hessian = gauss;
  hessian(0, 0) += r.dot(j.uu);
  hessian(1, 1) += r.dot(j.vv);
  hessian(0, 1) += r.dot(j.uv);
  hessian(1, 0) = hessian(0, 1);
  std::array<bool, 2> held{};
  for (int d = 0; d < 2; ++d)
    held[static_cast<std::size_t>(d)] =
        (at(d) <= box.low(d) && gradient(d) > 0) || (at(d) >= box.high(d) && gradient(d) < 0);
  Eigen::Vector2d result = Eigen::Vector2d::Zero();
  if (held[0] && held[1]) return result;
  for (int d = 0; d < 2; ++d)
    if (held[static_cast<std::size_t>(1 - d)]) {
      const double curvature = hessian(d, d) > 0 ? hessian(d, d) : gauss(d, d);
      if (curvature > 0) result(d) = -gradient(d) / curvature;
      return result;
    }
  const bool positive = hessian(0, 0) > 0 && hessian.determinant() > 1e-12 * gauss(0, 0) * gauss(1, 1);
  if (positive) return -hessian.inverse() * gradient;
  const double ridge = 1e-12 * gauss.trace() + 1e-300;
  return -(gauss + ridge * Eigen::Matrix2d::Identity()).inverse() * gradient;
}

int samples(int spans, int degree, bool turns, double range) {
  const int for_spline = spans * std::max(2, degree) + 1;
  const int for_turn = turns ? static_cast<int>(std::ceil(range / (std::numbers::pi / 4))) * 2 + 1 : 0;
  return std::clamp(std::max({for_spline, for_turn, 5}), 5, 80);
}

}  // namespace

SurfaceGrid surface_grid(const Geom_Surface& surface, const DomainBox& box) {
  const GeomAdaptor_Surface adaptor(Handle(Geom_Surface)(const_cast<Geom_Surface*>(&surface)));
  const bool spline =
      adaptor.GetType() == GeomAbs_BSplineSurface || adaptor.GetType() == GeomAbs_BezierSurface;
  const bool bspline = adaptor.GetType() == GeomAbs_BSplineSurface;
  const bool turning = !spline && adaptor.GetType() != GeomAbs_Plane;
  const Eigen::Vector2d range = box.high - box.low;
  const int nu =
      samples(bspline ? adaptor.NbUKnots() - 1 : 1, spline ? adaptor.UDegree() : 4, turning, range.x());
  const int nv = samples(bspline ? adaptor.NbVKnots() - 1 : 1, spline ? adaptor.VDegree() : 4,
                         turning && adaptor.IsVPeriodic(), range.y());
  SurfaceGrid grid;
  grid.uv.resize(2, nu * nv);
  grid.points.resize(3, nu * nv);
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const int k = i + nu * j;
      grid.uv.col(k) =
          box.low + range.cwiseProduct(Eigen::Vector2d(double(i) / (nu - 1), double(j) / (nv - 1)));
      grid.points.col(k) = to_eigen(surface.Value(grid.uv(0, k), grid.uv(1, k)));
    }
  return grid;
}

SurfaceDescent descend(const Geom_Surface& surface, const DomainBox& box, const Eigen::Vector2d& start,
                       const Eigen::Vector3d& target) {
  const Eigen::Vector2d range = box.high - box.low;
  Eigen::Vector2d at = clamped(start, box);
  Jet here = jet(surface, at);
  double distance = (here.point - target).norm();
  bool converged = false;
  for (int iteration = 0; iteration < 50 && !converged; ++iteration) {
    const Eigen::Vector2d direction = step(here, target, at, box);
    double share = 1;
    bool nearer = false;
    for (int halving = 0; halving < 30 && !nearer; ++halving, share /= 2) {
      const Eigen::Vector2d next = clamped(at + share * direction, box);
      const Eigen::Vector2d moved = (next - at).cwiseQuotient(range.cwiseMax(1e-300));
      const double length = moved.cwiseAbs().maxCoeff();
      if (length < 1e-15) break;
      const Jet there = jet(surface, next);
      const double far = (there.point - target).norm();
      if (far > distance && length > 1e-9) continue;
      nearer = far <= distance;
      if (nearer) {
        at = next;
        here = there;
        distance = far;
      }
      converged = length < 1e-12;
      if (!nearer) break;
    }
    if (!nearer) converged = true;
  }
  return {{at, here.point, distance}, converged};
}

SurfacePoint nearest_point(const Geom_Surface& surface, const DomainBox& box, const SurfaceGrid& grid,
                           const Eigen::Vector3d& target) {
  const Eigen::VectorXd distances = (grid.points.colwise() - target).colwise().squaredNorm();
  std::vector<int> order(static_cast<std::size_t>(distances.size()));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto starts = std::min<std::ptrdiff_t>(6, static_cast<std::ptrdiff_t>(order.size()));
  std::partial_sort(order.begin(), order.begin() + starts, order.end(),
                    [&](int a, int b) { return distances(a) < distances(b); });
  SurfacePoint best;
  best.distance = std::numeric_limits<double>::infinity();
  for (std::ptrdiff_t i = 0; i < starts; ++i) {
    const SurfacePoint found =
        descend(surface, box, grid.uv.col(order[static_cast<std::size_t>(i)]), target).found;
    if (found.distance < best.distance) best = found;
  }
  return best;
}

double nearest_parameter(const Geom_Curve& curve, double first, double last, const Eigen::Vector3d& target) {
  const GeomAdaptor_Curve adaptor(Handle(Geom_Curve)(const_cast<Geom_Curve*>(&curve)), first, last);
  const bool spline = adaptor.GetType() == GeomAbs_BSplineCurve;
  const int count = std::clamp(spline ? (adaptor.NbKnots() - 1) * (adaptor.Degree() + 1) : 0, 24, 400);
  const auto distance_at = [&](double t) { return (to_eigen(curve.Value(t)) - target).norm(); };
  std::vector<std::pair<double, double>> seeds;
  for (int i = 0; i <= count; ++i) {
    const double t = first + (last - first) * i / count;
    seeds.emplace_back(distance_at(t), t);
  }
  std::partial_sort(seeds.begin(), seeds.begin() + 3, seeds.end());
  double best = seeds[0].second, best_distance = seeds[0].first;
  for (int seed = 0; seed < 3; ++seed) {
    double t = seeds[static_cast<std::size_t>(seed)].second,
           distance = seeds[static_cast<std::size_t>(seed)].first;
    for (int iteration = 0; iteration < 50; ++iteration) {
      gp_Pnt p;
      gp_Vec d1, d2;
      curve.D2(t, p, d1, d2);
      const Eigen::Vector3d r = to_eigen(p) - target, c1 = to_eigen(d1);
      const double slope = r.dot(c1), newton = c1.squaredNorm() + r.dot(to_eigen(d2));
      double move = -slope / (newton > 1e-3 * c1.squaredNorm() ? newton : c1.squaredNorm() + 1e-300);
      bool nearer = false;
      for (int halving = 0; halving < 30 && !nearer; ++halving, move /= 2) {
        const double next = std::clamp(t + move, first, last);
        if (std::abs(next - t) < 1e-15 * (last - first)) break;
        const double far = distance_at(next);
        if (far > distance) continue;
        nearer = true;
        t = next;
        distance = far;
      }
      if (!nearer || std::abs(move) < 1e-14 * (last - first)) break;
    }
    if (distance < best_distance) best = t, best_distance = distance;
  }
  return best;
}

}  // namespace isopatch::geometry
