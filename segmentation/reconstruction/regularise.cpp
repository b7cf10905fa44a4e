#include "segmentation/reconstruction/internal/regularise.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "geometry/base/dense_matrices.hpp"
#include "segmentation/reconstruction/internal/carrier_distance.hpp"
#include "segmentation/reconstruction/internal/fit_carrier.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::SurfaceKind;

// Directions are known up to the tolerance over the size of the face; of small faces, up to several times
// that.
constexpr double direction_steps = 10;
constexpr double largest_turn = 2e-3;  // rad; a draft of a tenth of a degree is meant
constexpr double kept_within = 3;
// What was farther off before, as dents of a plane are, may stay so.
constexpr double kept_of_dents = 1.2;
constexpr std::size_t most_fit_points = 400;

struct Surface {
  std::size_t region;
  Carrier carrier;
  Eigen::Matrix3Xd points;
  double spread = 0;                           ///< least extent that determines the axis' direction, m
  double off = 0;                              ///< of a point from the carrier as it was found, m
  int direction = -1, axis = -1, radius = -1;  ///< groups
};

/// The direction of the most surfaces, weighted by how well each knows it.
struct Direction {
  Eigen::Vector3d axis;
  double error = 0;  ///< rad
};

class Regulariser {
 public:
  Regulariser(const geometry::TriangleMesh& mesh, Regions& regions, double tolerance)
      : mesh_(mesh), regions_(regions), tolerance_(tolerance), size_(geometry::diagonal(mesh)) {}

  Regularity run() {
    for (std::size_t r = 0; r < regions_.regions.size(); ++r)
      if (regions_.regions[r].carrier) surfaces_.push_back(surface(r));
    align_directions();
    align_axes();
    align_radii();
    for (const Surface& s : surfaces_) {
      Region& region = regions_.regions[s.region];
      region.carrier = s.carrier;
      region.deviation = 0;
      for (const int t : region.triangles)
        for (int i = 0; i < 3; ++i)
          region.deviation = std::fmax(
              region.deviation,
              std::abs(carrier_distance(s.carrier, mesh_.vertices.col(mesh_.triangles(i, t))).value));
    }
    return result_;
  }

 private:
  Surface surface(std::size_t r) const {
    const Region& region = regions_.regions[r];
    std::vector<int> vertices;
    for (const int t : region.triangles)
      for (int i = 0; i < 3; ++i) vertices.push_back(mesh_.triangles(i, t));
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    Surface result{r, *region.carrier, Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(vertices.size()))};
    for (std::size_t i = 0; i < vertices.size(); ++i)
      result.points.col(static_cast<Eigen::Index>(i)) = mesh_.vertices.col(vertices[i]);
    for (const auto& p : result.points.colwise())
      result.off = std::fmax(result.off, std::abs(carrier_distance(result.carrier, p).value));
    const Eigen::Matrix3Xd about = result.points.colwise() - result.points.rowwise().mean();
    const Eigen::Vector3d squares = principal_axes(about * about.transpose() / double(about.cols())).values;
    result.spread =
        std::sqrt(std::max(0.0, result.carrier.kind == SurfaceKind::plane ? squares[1] : squares[2] / 4));
    if (result.carrier.kind != SurfaceKind::plane && result.carrier.kind != SurfaceKind::sphere) {
      const Eigen::RowVectorXd heights = result.carrier.axis.transpose() * about;
      const double length = heights.maxCoeff() - heights.minCoeff();
      result.spread = result.carrier.kind == SurfaceKind::torus ? result.spread : length / 2;
    }
    return result;
  }

  double error_of(const Surface& s) const {
    return std::min(largest_turn, direction_steps * tolerance_ / std::max(s.spread, 1e-300));
  }

  /// Fits the surface again, starting from another carrier, and keeps the result if the vertices are within
  /// the tolerance of it.
  /// @return  whether it was kept
  bool accept(Surface& s, const Carrier& start, const FitFreedom& free) {
    const auto found = refit_carrier(start, few(s.points), free);
    if (!found) return false;
    double off = 0;
    for (const auto& p : s.points.colwise())
      off = std::fmax(off, std::abs(carrier_distance(found->carrier, p).value));
    if (!(off <= std::fmax(kept_within * tolerance_, kept_of_dents * s.off))) return false;
    s.carrier = found->carrier;
    return true;
  }

  static Eigen::Matrix3Xd few(const Eigen::Matrix3Xd& points) {
    const auto count = static_cast<std::size_t>(points.cols());
    const std::size_t step = 1 + count / most_fit_points;
    Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>((count + step - 1) / step));
    for (std::size_t i = 0; i < count; i += step)
      result.col(static_cast<Eigen::Index>(i / step)) = points.col(static_cast<Eigen::Index>(i));
    return result;
  }

  static double turn_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
  }
  static Eigen::Vector3d along(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.dot(b) < 0 ? Eigen::Vector3d(-a) : a;
  }

  void align_directions() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      if (surfaces_[i].carrier.kind != SurfaceKind::sphere) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return error_of(surfaces_[a]) < error_of(surfaces_[b]);
    });
    for (const std::size_t i : order) {
      Surface& s = surfaces_[i];
      for (std::size_t d = 0; d < directions_.size() && s.direction < 0; ++d)
        if (turn_between(s.carrier.axis, directions_[d].axis) <= error_of(s) + directions_[d].error)
          s.direction = static_cast<int>(d);
      if (s.direction >= 0) continue;
      s.direction = static_cast<int>(directions_.size());
      directions_.push_back({squared(s.carrier.axis, error_of(s)), error_of(s)});
    }
    for (const std::size_t i : order) {
      Surface& s = surfaces_[i];
      Carrier turned = s.carrier;
      turned.axis = along(directions_[static_cast<std::size_t>(s.direction)].axis, s.carrier.axis);
      if (turned.axis == s.carrier.axis) continue;
      // Turned about where the face is, not about an origin far away.
      turned.origin = near_face(s);
      if (turned.kind == SurfaceKind::cone)
        turned.radius +=
            s.carrier.axis.dot(turned.origin - s.carrier.origin) * std::tan(turned.half_angle.radians());
      if (accept(s, turned, {.turn = false}))
        ++result_.parallel;
      else
        s.direction = -1;
    }
  }

  static Eigen::Vector3d near_face(const Surface& s) {
    if (s.carrier.kind == SurfaceKind::torus) return s.carrier.origin;
    const Eigen::Vector3d middle = s.points.rowwise().mean();
    const Eigen::Vector3d way = middle - s.carrier.origin;
    if (s.carrier.kind == SurfaceKind::plane) return middle - s.carrier.axis * s.carrier.axis.dot(way);
    return s.carrier.origin + s.carrier.axis * s.carrier.axis.dot(way);
  }

  /// An axis of the coordinates where it is one, else at right angles to the directions before that it is
  /// nearly at right angles to.
  Eigen::Vector3d squared(const Eigen::Vector3d& axis, double error) const {
    for (int i = 0; i < 3; ++i)
      if (turn_between(axis, Eigen::Vector3d::Unit(i)) <= error) return along(Eigen::Vector3d::Unit(i), axis);
    std::vector<Eigen::Vector3d> crossed;
    for (const Direction& d : directions_)
      if (std::abs(axis.dot(d.axis)) <= error + d.error && crossed.size() < 2) crossed.push_back(d.axis);
    if (crossed.size() == 2 && crossed[0].cross(crossed[1]).norm() > 0.1)
      return along(crossed[0].cross(crossed[1]).normalized(), axis);
    if (crossed.empty()) return axis;
    return (axis - crossed[0] * crossed[0].dot(axis)).normalized();
  }

  static bool has_axis(const Carrier& c) {
    return c.kind != SurfaceKind::plane && c.kind != SurfaceKind::sphere;
  }

  /// Distance of a point from an axis.
  static double off_axis(const Carrier& axis, const Eigen::Vector3d& point) {
    return axis.axis.cross(point - axis.origin).norm();
  }

  void align_axes() {
    std::vector<std::size_t> leaders;
    std::vector<std::size_t> order(surfaces_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // The largest first: they know best where their axis is. Spheres have none of their own.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const bool first = surfaces_[a].carrier.kind == SurfaceKind::sphere,
                 second = surfaces_[b].carrier.kind == SurfaceKind::sphere;
      if (first != second) return second;
      return surfaces_[a].spread > surfaces_[b].spread;
    });
    for (const std::size_t i : order) {
      Surface& s = surfaces_[i];
      const bool sphere = s.carrier.kind == SurfaceKind::sphere;
      if (!sphere && (!has_axis(s.carrier) || s.direction < 0)) continue;
      bool moved = false;
      for (const std::size_t l : leaders) {
        const Surface& leader = surfaces_[l];
        if (!sphere && leader.direction != s.direction) continue;
        const double off = off_axis(leader.carrier, s.carrier.origin);
        if (off > 10 * tolerance_) continue;
        Carrier on = s.carrier;
        on.axis = along(leader.carrier.axis, s.carrier.axis);
        on.origin = leader.carrier.origin +
                    leader.carrier.axis * leader.carrier.axis.dot(s.carrier.origin - leader.carrier.origin);
        moved = accept(s, on, {.turn = false, .shift = false});
        if (moved) {
          s.axis = static_cast<int>(l);
          result_.coaxial += off > 0;
          break;
        }
      }
      if (!moved && !sphere) leaders.push_back(i);
    }
  }

  void align_radii() {
    std::vector<double> radii;
    std::vector<std::size_t> order(surfaces_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return surfaces_[a].points.cols() > surfaces_[b].points.cols();
    });
    for (const std::size_t i : order) {
      Surface& s = surfaces_[i];
      if (s.carrier.kind != SurfaceKind::cylinder && s.carrier.kind != SurfaceKind::sphere &&
          s.carrier.kind != SurfaceKind::torus)
        continue;
      double& own = s.carrier.kind == SurfaceKind::torus ? s.carrier.second_radius : s.carrier.radius;
      const auto known = std::find_if(radii.begin(), radii.end(),
                                      [&](double r) { return std::abs(r - own) <= 2 * tolerance_; });
      if (known == radii.end()) {
        radii.push_back(own);
        continue;
      }
      Carrier equal = s.carrier;
      (s.carrier.kind == SurfaceKind::torus ? equal.second_radius : equal.radius) = *known;
      if (*known != own && accept(s, equal, {.turn = false, .shift = s.axis < 0, .radius = false}))
        ++result_.equal;
    }
  }

  const geometry::TriangleMesh& mesh_;
  Regions& regions_;
  double tolerance_, size_;
  std::vector<Surface> surfaces_;
  std::vector<Direction> directions_;
  Regularity result_;
};

}  // namespace

Regularity regularise(const geometry::TriangleMesh& mesh, Regions& regions, double tolerance) {
  return Regulariser(mesh, regions, tolerance).run();
}

}  // namespace isopatch::segmentation
