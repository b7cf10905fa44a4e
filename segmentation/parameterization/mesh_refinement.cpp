#include "segmentation/parameterization/internal/mesh_refinement.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "segmentation/parameterization/internal/outline.hpp"

namespace isopatch::segmentation {
namespace {

using Triangle = std::array<int, 3>;

/// A directed edge with the triangle to its left and the corner across.
struct EdgeOfTriangle {
  int from = 0, to = 0;
  std::size_t triangle = 0;
  int corner = 0;
};

/// All directed edges, by their ends.
class EdgeMap {
 public:
  EdgeMap(const std::vector<Triangle>& triangles, std::size_t points) : first_(points + 1, 0) {
    for (const Triangle& corners : triangles)
      for (const int corner : corners) ++first_[static_cast<std::size_t>(corner) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    edges_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = triangles[t][k];
        edges_[next[static_cast<std::size_t>(from)]++] = {from, triangles[t][(k + 1) % 3], t,
                                                          triangles[t][(k + 2) % 3]};
      }
    for (std::size_t i = 0; i < points; ++i)
      std::sort(edges_.begin() + static_cast<std::ptrdiff_t>(first_[i]),
                edges_.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]),
                [](const EdgeOfTriangle& a, const EdgeOfTriangle& b) { return a.to < b.to; });
  }

  auto begin() const { return edges_.begin(); }
  auto end() const { return edges_.end(); }
  /// Null for none.
  const EdgeOfTriangle* find(int from, int to) const {
    for (std::size_t i = first_[static_cast<std::size_t>(from)];
         i < first_[static_cast<std::size_t>(from) + 1]; ++i)
      if (edges_[i].to == to) return &edges_[i];
    return nullptr;
  }

 private:
  std::vector<std::size_t> first_;  ///< of each point
  std::vector<EdgeOfTriangle> edges_;
};

/// Rounds of flips between two rounds of halving.
constexpr int flips_between = 3;

/// A mesh at work: points in no order, with what is known of those of the outline.
class Refinement {
 public:
  Refinement(const DomainMesh& mesh, const std::array<DomainCurve, 4>& sides, const DomainSurface& surface)
      : sides_(sides), surface_(surface), triangles_(mesh.triangles) {
    for (const Eigen::Vector2d& point : mesh.points) add(point, {});
    const std::size_t n = mesh.outline.size();
    for (std::size_t i = 0; i < n; ++i) on_outline_[i] = mesh.outline[i];
    find_stretch();
  }

  /// Halves the outline's pieces that are longer in space than a share of their side.
  void halve_outline(int pieces) {
    std::array<double, 4> limit{};
    for (const auto& [a, b, triangle, corner] : edge_map()) {
      if (const int side = side_of(a, b); side >= 0) limit[static_cast<std::size_t>(side)] += length(a, b);
    }
    for (double& x : limit) x /= pieces;
    while (halve([&](int a, int b, bool inner) {
      const int side = inner ? -1 : side_of(a, b);
      return side >= 0 && length(a, b) > limit[static_cast<std::size_t>(side)];
    }))
      flip(flips_between);
  }

  void halve_inside(int triangles) {
    // An equilateral triangle of side h has the area 0.433 h^2.
    const double h = std::sqrt(area() / (0.433 * triangles));
    constexpr int most_rounds = 40;
    for (int i = 0; i < most_rounds; ++i) {
      // Halves of longer edges are a little shorter than h on average.
      if (!halve([&](int a, int b, bool inner) { return inner && length(a, b) > 1.4 * h; })) break;
      flip(flips_between);
    }
  }

  void separate_sides() {
    while (halve([&](int a, int b, bool inner) { return inner && side_of(a, b) >= 0; })) {
    }
  }

  void flip(int most_rounds) {
    for (int i = 0; i < most_rounds && flip_round(); ++i) {
    }
  }

  DomainMesh result() const {
    std::vector<int> order = outline_order();
    DomainMesh mesh;
    std::vector<int> number(points_.size(), -1);
    for (const int i : order) {
      number[static_cast<std::size_t>(i)] = static_cast<int>(mesh.points.size());
      mesh.points.push_back(points_[static_cast<std::size_t>(i)]);
      mesh.outline.push_back(*on_outline_[static_cast<std::size_t>(i)]);
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (number[i] < 0) {
        number[i] = static_cast<int>(mesh.points.size());
        mesh.points.push_back(points_[i]);
      }
    for (const Triangle& t : triangles_)
      mesh.triangles.push_back({number[static_cast<std::size_t>(t[0])],
                                number[static_cast<std::size_t>(t[1])],
                                number[static_cast<std::size_t>(t[2])]});
    return mesh;
  }

 private:
  int add(const Eigen::Vector2d& point, const std::optional<OutlinePoint>& on_outline) {
    points_.push_back(point);
    spots_.push_back(surface_(point));
    on_outline_.push_back(on_outline);
    return static_cast<int>(points_.size()) - 1;
  }

  const std::optional<OutlinePoint>& outline_point(int i) const {
    return on_outline_[static_cast<std::size_t>(i)];
  }

  /// Whether a point of the outline lies on a side, its ends included; its curve's parameter there.
  std::optional<double> parameter_on(const OutlinePoint& point, int side) const {
    if (point.side == side) return point.t;
    // The corner that the side ends with, on its way around, belongs to the next one.
    const bool at_start = point.t == 0, at_end = point.t == 1;
    if (side == 0 && point.side == 3 && at_start) return 1.0;
    if (side == 3 && point.side == 1 && at_end) return 1.0;
    if (side == 1 && point.side == 2 && at_end) return 0.0;
    if (side == 2 && point.side == 0 && at_start) return 0.0;
    return std::nullopt;
  }

  /// The side that both points lie on; -1 for none.
  int side_of(int a, int b) const {
    const auto &p = outline_point(a), &q = outline_point(b);
    if (!p || !q) return -1;
    for (int side = 0; side < 4; ++side)
      if (parameter_on(*p, side) && parameter_on(*q, side)) return side;
    return -1;
  }

  EdgeMap edge_map() const { return {triangles_, points_.size()}; }

  double length(int a, int b) const {
    return (spots_[static_cast<std::size_t>(a)] - spots_[static_cast<std::size_t>(b)]).norm();
  }

  double area() const {
    double sum = 0;
    for (const Triangle& t : triangles_) {
      const auto& a = spots_[static_cast<std::size_t>(t[0])];
      sum += (spots_[static_cast<std::size_t>(t[1])] - a)
                 .cross(spots_[static_cast<std::size_t>(t[2])] - a)
                 .norm() /
             2;
    }
    return sum;
  }

  /// Factors that make the domain's two directions about as long as they are on the surface, and the outline
  /// counterclockwise.
  void find_stretch() {
    Eigen::AlignedBox2d box;
    for (const auto& p : points_) box.extend(p);
    Eigen::Vector2d sum(0, 0);
    double doubled = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!on_outline_[i]) continue;
      for (int d = 0; d < 2; ++d) {
        const double step = 1e-3 * box.sizes()[d] * (points_[i][d] > box.center()[d] ? -1 : 1);
        const Eigen::Vector2d beside = points_[i] + step * Eigen::Vector2d::Unit(d);
        sum[d] += (surface_(beside) - spots_[i]).norm() / std::abs(step);
      }
    }
    if (sum[0] > 0 && sum[1] > 0) stretch_ = sum / sum.maxCoeff();
    for (const Triangle& t : triangles_) doubled += doubled_area(at(t[0]), at(t[1]), at(t[2]));
    if (doubled < 0) stretch_[1] = -stretch_[1];
  }

  Eigen::Vector2d at(int i) const { return points_[static_cast<std::size_t>(i)].cwiseProduct(stretch_); }

  // Sine-like measure of the smallest angle: least height over longest side. Negative for a turned triangle.
  double shape(int a, int b, int c) const {
    const Eigen::Vector2d p = at(a), q = at(b), r = at(c);
    const double longest =
        std::max(std::max((p - q).squaredNorm(), (q - r).squaredNorm()), (r - p).squaredNorm());
    return doubled_area(p, q, r) / longest;
  }

  // The middle of an edge; of a piece of the outline on its curve, if that leaves the triangle beside it
  // whole.
  int middle(int a, int b, std::optional<int> only_corner) {
    const Eigen::Vector2d half =
        (points_[static_cast<std::size_t>(a)] + points_[static_cast<std::size_t>(b)]) / 2;
    if (!only_corner) return add(half, {});
    const int side = side_of(a, b);
    const double t = (*parameter_on(*outline_point(a), side) + *parameter_on(*outline_point(b), side)) / 2;
    const int m = add(sides_[static_cast<std::size_t>(side)](t), OutlinePoint{side, t});
    if (shape(a, m, *only_corner) > 0 && shape(m, b, *only_corner) > 0) return m;
    points_.back() = half;
    spots_.back() = surface_(half);
    return m;
  }

  // Halves edges, longest first, no triangle twice. Returns whether there was any.
  template <class Which>
  bool halve(Which which) {
    const EdgeMap map = edge_map();
    std::vector<std::pair<double, std::pair<int, int>>> chosen;
    for (const auto& [a, b, triangle, corner] : map) {
      const bool inner = map.find(b, a) != nullptr;
      if ((!inner || a < b) && which(a, b, inner)) chosen.push_back({-length(a, b), {a, b}});
    }
    std::sort(chosen.begin(), chosen.end());
    std::vector<bool> touched(triangles_.size(), false);
    for (const auto& entry : chosen) {
      const auto [a, b] = entry.second;
      const auto& [from, to, left, c] = *map.find(a, b);
      const EdgeOfTriangle* other = map.find(b, a);
      if (touched[left] || (other && touched[other->triangle])) continue;
      touched[left] = true;
      const int m = middle(a, b, other ? std::nullopt : std::optional(c));
      triangles_[left] = {a, m, c};
      triangles_.push_back({m, b, c});
      if (!other) continue;
      const std::size_t right = other->triangle;
      const int d = other->corner;
      touched[right] = true;
      triangles_[right] = {b, m, d};
      triangles_.push_back({m, a, d});
    }
    return !chosen.empty();
  }

  // One round over all edges, no triangle touched twice. Returns whether one was flipped.
  bool flip_round() {
    const EdgeMap map = edge_map();
    std::vector<bool> touched(triangles_.size(), false);
    bool flipped = false;
    for (const auto& [a, b, left_triangle, c] : map) {
      if (a > b) continue;
      const EdgeOfTriangle* other = map.find(b, a);
      if (!other) continue;
      const std::size_t right_triangle = other->triangle;
      const int d = other->corner;
      if (touched[left_triangle] || touched[right_triangle]) continue;
      const double now = std::min(shape(a, b, c), shape(b, a, d));
      const double then = std::min(shape(a, d, c), shape(d, b, c));
      if (then <= now + 1e-12) continue;
      triangles_[left_triangle] = {a, d, c};
      triangles_[right_triangle] = {d, b, c};
      touched[left_triangle] = touched[right_triangle] = flipped = true;
    }
    return flipped;
  }

  /// The outline's points all around.
  std::vector<int> outline_order() const {
    std::vector<std::pair<double, int>> along;
    for (std::size_t i = 0; i < on_outline_.size(); ++i) {
      if (!on_outline_[i]) continue;
      const OutlinePoint& point = *on_outline_[i];
      const double way = point.side == 0   ? point.t
                         : point.side == 3 ? 1 + point.t
                         : point.side == 1 ? 3 - point.t
                                           : 4 - point.t;
      along.push_back({way, static_cast<int>(i)});
    }
    std::sort(along.begin(), along.end());
    std::vector<int> order;
    for (const auto& entry : along) order.push_back(entry.second);
    return order;
  }

  const std::array<DomainCurve, 4>& sides_;
  const DomainSurface& surface_;
  std::vector<Eigen::Vector2d> points_;
  std::vector<Eigen::Vector3d> spots_;  ///< the points on the surface
  std::vector<std::optional<OutlinePoint>> on_outline_;
  std::vector<Triangle> triangles_;
  Eigen::Vector2d stretch_ = Eigen::Vector2d(1, 1);
};

}  // namespace

DomainMesh refined(DomainMesh mesh, const std::array<DomainCurve, 4>& sides, const DomainSurface& surface,
                   int outline_pieces, int triangles) {
  Refinement refinement(mesh, sides, surface);
  constexpr int most_flips = 50;
  refinement.flip(most_flips);
  refinement.halve_outline(outline_pieces);
  refinement.halve_inside(triangles);
  refinement.flip(most_flips);
  refinement.separate_sides();
  return refinement.result();
}

}  // namespace isopatch::segmentation
