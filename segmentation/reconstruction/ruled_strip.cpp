#include "segmentation/reconstruction/internal/ruled_strip.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"
#include "segmentation/reconstruction/internal/carrier_distance.hpp"
#include "segmentation/reconstruction/internal/chord_error.hpp"
#include "segmentation/reconstruction/internal/fit_curves.hpp"
#include "segmentation/reconstruction/internal/nearest_on_spline.hpp"
#include "segmentation/reconstruction/internal/slide_rulings.hpp"
#include "segmentation/reconstruction/internal/steady_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::EdgeUse;
using geometry::NurbsCurve;

// Normals of triangles between rounded vertices are off by the rounding over their width.
constexpr double upright_slope = 1e-4;
// Curves may be farther from the sides of triangles than the chord error, which is estimated, by this factor.
constexpr double chord_slack = 1.5;
// A wall is straight from plane to plane if it bends between them by no more than this share of its height.
constexpr double straight_share = 4e-3;

NurbsCurve line_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return NurbsCurve({geometry::KnotVector()}, (Eigen::Matrix3Xd(3, 2) << from, to).finished());
}

class StripMaker {
 public:
  StripMaker(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
             const Wireframe& wires, const Regions& regions, int region, double tolerance)
      : mesh_(mesh),
        neighbours_(neighbours),
        wires_(wires),
        regions_(regions),
        region_(region),
        tolerance_(tolerance) {}

  std::optional<RuledStrip> make() {
    const auto& loops = wires_.loops[static_cast<std::size_t>(region_)];
    if (loops.size() != 1 || loops.front().size() != 4) return std::nullopt;
    for (std::size_t first = 0; first < 2; ++first) {
      loop_ = loops.front();
      std::rotate(loop_.begin(), loop_.begin() + static_cast<std::ptrdiff_t>(first), loop_.end());
      if (!between_planes() || !has_straight_ends()) continue;
      if (auto strip = fitted()) return strip;
    }
    return std::nullopt;
  }

 private:
  const WireEdge& edge(std::size_t i) const {
    return wires_.edges[static_cast<std::size_t>(loop_[i].edge.value)];
  }
  /// Points of an edge as the loop runs.
  std::vector<Eigen::Vector3d> points(std::size_t i) const {
    std::vector<Eigen::Vector3d> result = edge(i).points;
    if (loop_[i].reversed) std::reverse(result.begin(), result.end());
    return result;
  }
  const std::optional<Carrier>& beside(std::size_t i) const {
    const auto& both = edge(i).regions;
    return regions_.regions[static_cast<std::size_t>(both[0] == region_ ? both[1] : both[0])].carrier;
  }
  const std::vector<int>& triangles() const {
    return regions_.regions[static_cast<std::size_t>(region_)].triangles;
  }

  /// Whether the first edge and the third are in parallel planes.
  bool between_planes() {
    const std::optional<Carrier>&low = beside(0), &high = beside(2);
    if (!low || !high || low->kind != geometry::SurfaceKind::plane ||
        high->kind != geometry::SurfaceKind::plane)
      return false;
    up_ = low->axis;
    if (up_.cross(high->axis).norm() > 1e-9) return false;
    height_ = up_.dot(high->origin - low->origin);
    if (height_ < 0) {
      up_ = -up_;
      height_ = -height_;
    }
    return height_ > 10 * tolerance_;
  }

  /// Whether the second edge and the fourth are lines, on the carriers beside them too; seams beside other
  /// freeform faces are as straight as walls.
  bool has_straight_ends() const {
    for (const std::size_t i : {1, 3}) {
      const std::vector<Eigen::Vector3d> all = points(i);
      const Eigen::Vector3d way = all.back() - all.front();
      const double near = beside(i) ? tolerance_ : std::max(tolerance_, straight_share * height_);
      for (const Eigen::Vector3d& p : all)
        if (way.cross(p - all.front()).norm() > near * way.norm()) return false;
      if (!beside(i)) continue;
      for (const double share : {0.25, 0.5, 0.75})
        if (std::abs(carrier_distance(*beside(i), all.front() + share * way).value) > tolerance_)
          return false;
    }
    return true;
  }

  /// A long edge, along u.
  CurveSample sample(std::size_t i) const {
    std::vector<Eigen::Vector3d> all = points(i);
    if (i == 2) std::reverse(all.begin(), all.end());
    return by_length(
        Eigen::Map<const Eigen::Matrix3Xd>(all.front().data(), 3, static_cast<Eigen::Index>(all.size())));
  }

  bool is_upright() const {
    return std::all_of(triangles().begin(), triangles().end(), [&](int t) {
      return std::abs(geometry::area_vector(mesh_, t).normalized().dot(up_)) < upright_slope;
    });
  }

  /// The two long curves of a wall at right angles to the planes: one, and the same higher up.
  std::optional<RuledCurves> upright_curves(const CurveSample& low, const CurveSample& high) const {
    std::vector<std::pair<double, Eigen::Vector3d>> all;
    for (Eigen::Index i = 0; i < low.t.size(); ++i) all.emplace_back(low.t[i], low.points.col(i));
    for (Eigen::Index i = 0; i < high.t.size(); ++i)
      all.emplace_back(high.t[i], high.points.col(i) - height_ * up_);
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    CurveSample both{Eigen::VectorXd(static_cast<Eigen::Index>(all.size())), Eigen::Matrix3Xd(3, all.size())};
    for (std::size_t i = 0; i < all.size(); ++i) {
      both.t[static_cast<Eigen::Index>(i)] = all[i].first;
      both.points.col(static_cast<Eigen::Index>(i)) = all[i].second;
    }
    const FittedCurves fit = fit_curves({both}, tolerance_);
    if (fit.largest > 3 * tolerance_) return std::nullopt;
    const NurbsCurve& first = fit.curves.front();
    return RuledCurves{first, NurbsCurve(first.knots(), first.control_points().colwise() + height_ * up_),
                       fit.largest, fit.largest};
  }

  std::optional<RuledCurves> inclined_curves(const CurveSample& low, const CurveSample& high) const {
    RuledPoints all{Eigen::Matrix3Xd(3, low.t.size() + high.t.size()), {}, up_};
    all.points << low.points, high.points;
    const std::vector<int> inside = vertices_inside();
    const Eigen::Index known = all.points.cols();
    all.points.conservativeResize(3, known + static_cast<Eigen::Index>(inside.size()));
    for (std::size_t i = 0; i < inside.size(); ++i)
      all.points.col(known + static_cast<Eigen::Index>(i)) = mesh_.vertices.col(inside[i]);
    all.v = ((up_.transpose() * (all.points.colwise() - low.points.col(0))) / height_).transpose();
    return steadiest(low, high, all);
  }

  /// Curves as near to their points as they can be without waves between them, and no farther than the
  /// triangles say: between the points too, if any are; nothing without steady ones.
  std::optional<RuledCurves> steadiest(const CurveSample& low, const CurveSample& high,
                                       const RuledPoints& all) const {
    std::optional<RuledCurves> result;
    double least = std::numeric_limits<double>::infinity();
    for (double near = tolerance_; near <= largest_on_curves(); near *= 2) {
      const FittedCurves fit = fit_curves({low, high}, near);
      const RuledCurves plain = {fit.curves[0], fit.curves[1],
                                 std::max(fit.largest, off_inside(fit.curves, all)), fit.largest};
      for (const RuledCurves& curves : {slide_rulings({fit.curves[0], fit.curves[1]}, all, near), plain}) {
        if (!is_near(curves) || !is_steady(curves.low, low.points) || !is_steady(curves.high, high.points))
          continue;
        const double off = std::max(farthest(curves.low, low.points), farthest(curves.high, high.points));
        if (off < least) {
          least = off;
          result = curves;
        }
        if (off <= chord_slack * largest_on_curves()) return curves;
      }
    }
    return result;
  }
  double largest_on_curves() const { return std::max(3 * tolerance_, chord()); }
  bool is_near(const RuledCurves& curves) const {
    return curves.largest_on_curves <= largest_on_curves() &&
           curves.largest <= tolerance_ + std::max(chord(), straight_share * height_);
  }

  /// Distance of the points between two curves from the surface between them.
  double off_inside(const std::vector<NurbsCurve>& curves, const RuledPoints& all) const {
    const NearestOnSpline nearest(geometry::ruled(curves[0], curves[1]));
    double result = 0;
    for (Eigen::Index k = 0; k < all.points.cols(); ++k)
      if (all.v[k] > 0 && all.v[k] < 1)
        result = std::max(result, std::abs(nearest.distance(all.points.col(k)).value));
    return result;
  }

  /// Vertices of the mesh between the two planes.
  std::vector<int> vertices_inside() const {
    const double bottom = up_.dot(edge(0).points.front());
    std::set<int> result;
    for (const int t : triangles())
      for (int i = 0; i < 3; ++i) {
        const double height = up_.dot(mesh_.vertices.col(mesh_.triangles(i, t))) - bottom;
        if (height > tolerance_ && height < height_ - tolerance_) result.insert(mesh_.triangles(i, t));
      }
    return {result.begin(), result.end()};
  }

  std::optional<RuledStrip> fitted() const {
    const CurveSample low = sample(0), high = sample(2);
    std::optional<RuledCurves> curves;
    if (is_upright()) curves = upright_curves(low, high);
    if (!curves) curves = inclined_curves(low, high);
    if (!curves || !is_near(*curves)) return std::nullopt;
    const NurbsCurve &below = curves->low, &above = curves->high;
    RuledStrip strip{geometry::ruled(below, above), {}, {}};
    const auto ends = [](const NurbsCurve& curve) {
      return std::pair<Eigen::Vector3d, Eigen::Vector3d>(curve.control_points().leftCols<1>(),
                                                         curve.control_points().rightCols<1>());
    };
    strip.curves = {below, line_between(ends(below).second, ends(above).second), geometry::reversed(above, 0),
                    line_between(ends(above).first, ends(below).first)};
    for (std::size_t i = 0; i < 4; ++i) {
      strip.edges[i] = loop_[i].edge.value;
      if (loop_[i].reversed) strip.curves[i] = geometry::reversed(strip.curves[i], 0);
    }
    return strip;
  }

  double chord() const { return chord_error(mesh_, neighbours_, regions_, region_); }

  const geometry::TriangleMesh& mesh_;
  const geometry::MeshNeighbours& neighbours_;
  const Wireframe& wires_;
  const Regions& regions_;
  int region_;
  double tolerance_;
  std::vector<EdgeUse> loop_;  // along the lower plane first, as seen from outside
  Eigen::Vector3d up_;
  double height_ = 0;
};

}  // namespace

std::optional<RuledStrip> ruled_strip(const geometry::TriangleMesh& mesh,
                                      const geometry::MeshNeighbours& neighbours, const Wireframe& wires,
                                      const Regions& regions, int region, double tolerance) {
  return StripMaker(mesh, neighbours, wires, regions, region, tolerance).make();
}

}  // namespace isopatch::segmentation
