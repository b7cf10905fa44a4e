#include "segmentation/profiles/internal/triangulate.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;

namespace {

using Triangle = std::array<int, 3>;

/// Twice the area of a triangle, positive if counterclockwise.
double area2(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// One polygon, whose points may repeat where holes are joined to it.
class Ears {
 public:
  Ears(const std::vector<Vector2d>& points, std::vector<std::vector<int>> loops)
      : points_(points), loops_(std::move(loops)) {}

  std::optional<std::vector<Triangle>> cut() {
    if (!join_holes()) return std::nullopt;
    std::vector<Triangle> result;
    std::vector<int> polygon = polygon_;
    std::size_t at = 0, refused = 0;
    while (polygon.size() > 3) {
      const std::size_t n = polygon.size();
      at %= n;
      if (is_ear(polygon, at)) {
        result.push_back({polygon[(at + n - 1) % n], polygon[at], polygon[(at + 1) % n]});
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(at));
        refused = 0;
      } else if (++refused > n) {
        return std::nullopt;
      }
      ++at;
    }
    if (polygon.size() == 3) result.push_back({polygon[0], polygon[1], polygon[2]});
    return result;
  }

 private:
  const Vector2d& point(int i) const { return points_[static_cast<std::size_t>(i)]; }

  bool join_holes() {
    polygon_ = loops_.front();
    std::vector<std::size_t> holes(loops_.size() - 1);
    std::iota(holes.begin(), holes.end(), 1U);
    const auto left = [&](std::size_t hole) {
      return *std::min_element(loops_[hole].begin(), loops_[hole].end(), [&](int a, int b) {
        return std::pair(point(a).x(), point(a).y()) < std::pair(point(b).x(), point(b).y());
      });
    };
    std::sort(holes.begin(), holes.end(),
              [&](std::size_t a, std::size_t b) { return point(left(a)).x() < point(left(b)).x(); });
    return std::all_of(holes.begin(), holes.end(),
                       [&](std::size_t hole) { return join(loops_[hole], left(hole)); });
  }

  bool join(const std::vector<int>& hole, int from) {
    std::vector<std::size_t> order(polygon_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return (point(polygon_[a]) - point(from)).squaredNorm() <
             (point(polygon_[b]) - point(from)).squaredNorm();
    });
    for (const std::size_t at : order) {
      if (!in_sector(at, point(from)) || !visible(polygon_[at], from)) continue;
      const auto first = std::find(hole.begin(), hole.end(), from);
      std::vector<int> detour = {polygon_[at]};
      detour.insert(detour.end(), first, hole.end());
      detour.insert(detour.end(), hole.begin(), first);
      detour.push_back(from);
      polygon_.insert(polygon_.begin() + static_cast<std::ptrdiff_t>(at), detour.begin(), detour.end());
      return true;
    }
    return false;
  }

  /// Whether a point lies between the polygon's edges at a corner.
  bool in_sector(std::size_t at, const Vector2d& to) const {
    const std::size_t n = polygon_.size();
    const Vector2d &a = point(polygon_[(at + n - 1) % n]), &b = point(polygon_[at]),
                   &c = point(polygon_[(at + 1) % n]);
    const bool convex = area2(a, b, c) >= 0;
    const bool left_of_in = area2(a, b, to) > 0, left_of_out = area2(b, c, to) > 0;
    return convex ? left_of_in && left_of_out : left_of_in || left_of_out;
  }

  bool visible(int a, int b) const {
    const auto clear_of = [&](const std::vector<int>& loop) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int c = loop[i], d = loop[(i + 1) % loop.size()];
        if (a == c || a == d || b == c || b == d) continue;
        if (segments_meet(point(a), point(b), point(c), point(d))) return false;
      }
      return true;
    };
    return clear_of(polygon_) && std::all_of(loops_.begin(), loops_.end(), clear_of);
  }

  bool is_ear(const std::vector<int>& polygon, std::size_t at) const {
    const std::size_t n = polygon.size();
    const int a = polygon[(at + n - 1) % n], b = polygon[at], c = polygon[(at + 1) % n];
    const Vector2d &pa = point(a), &pb = point(b), &pc = point(c);
    const double tolerance = 1e-12 * ((pb - pa).squaredNorm() + (pc - pb).squaredNorm());
    if (a == c || area2(pa, pb, pc) <= tolerance) return false;
    for (std::size_t i = 0; i < n; ++i) {
      const int other = polygon[i];
      if (other == a || other == b || other == c) continue;
      const Vector2d& p = point(other);
      if (area2(pa, pb, p) >= 0 && area2(pb, pc, p) >= 0 && area2(pc, pa, p) >= -tolerance) return false;
    }
    return true;
  }

  const std::vector<Vector2d>& points_;
  std::vector<std::vector<int>> loops_;
  std::vector<int> polygon_;
};

bool in_circle(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  Eigen::Matrix3d m;
  int row = 0;
  double scale = 0;
  for (const Vector2d* p : {&a, &b, &c}) {
    const Vector2d q = *p - d;
    m.row(row++) << q.x(), q.y(), q.squaredNorm();
    scale = std::max(scale, q.squaredNorm());
  }
  return m.determinant() > 1e-10 * scale * scale;
}

/// Flips edges inside until each is Delaunay (or a bound on the flips is met).
void flip(const std::vector<Vector2d>& points, const std::vector<std::vector<int>>& loops,
          std::vector<Triangle>& triangles) {
  std::map<std::pair<int, int>, int> of;  // a directed edge's triangle
  const auto enter = [&](int t) {
    for (int k = 0; k < 3; ++k) of[{triangles[t][k], triangles[t][(k + 1) % 3]}] = t;
  };
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) enter(t);
  std::map<std::pair<int, int>, bool> fixed;
  for (const std::vector<int>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) fixed[{loop[i], loop[(i + 1) % loop.size()]}] = true;
  std::vector<std::pair<int, int>> todo;
  for (const auto& [edge, t] : of) todo.push_back(edge);
  for (std::size_t rounds = 50 * todo.size(); !todo.empty() && rounds > 0; --rounds) {
    const int a = todo.back().first, b = todo.back().second;  // no bindings: a lambda takes them
    todo.pop_back();
    const auto one = of.find({a, b}), two = of.find({b, a});
    if (one == of.end() || two == of.end() || fixed.contains({a, b}) || fixed.contains({b, a})) continue;
    const auto third = [&](int t) {
      for (const int corner : triangles[t])
        if (corner != a && corner != b) return corner;
      return -1;
    };
    const int s = one->second, t = two->second, c = third(s), d = third(t);
    if (c < 0 || d < 0 || c == d || !in_circle(points[a], points[b], points[c], points[d])) continue;
    if (area2(points[a], points[d], points[c]) <= 0 || area2(points[d], points[b], points[c]) <= 0) continue;
    of.erase(one);
    of.erase({b, a});
    triangles[s] = {a, d, c};
    triangles[t] = {d, b, c};
    enter(s);
    enter(t);
    todo.insert(todo.end(), {{a, d}, {d, b}, {b, c}, {c, a}});
  }
}

}  // namespace

bool segments_meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  if (std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x()) ||
      std::max(a.y(), b.y()) < std::min(c.y(), d.y()) || std::max(c.y(), d.y()) < std::min(a.y(), b.y()))
    return false;
  const double tolerance = 1e-12 * ((b - a).squaredNorm() + (d - c).squaredNorm());
  const auto sign = [&](double area) { return area > tolerance ? 1 : area < -tolerance ? -1 : 0; };
  const int s1 = sign(area2(a, b, c)), s2 = sign(area2(a, b, d)), s3 = sign(area2(c, d, a)),
            s4 = sign(area2(c, d, b));
  if (s1 * s2 > 0 || s3 * s4 > 0) return false;
  if (s1 != 0 || s2 != 0 || s3 != 0 || s4 != 0) return true;
  const Vector2d along = b - a;  // on one line
  const double low = std::min(along.dot(c - a), along.dot(d - a)),
               high = std::max(along.dot(c - a), along.dot(d - a));
  return low <= along.squaredNorm() && high >= 0;
}

std::optional<std::vector<Triangle>> triangulate(const std::vector<Vector2d>& points,
                                                 const std::vector<std::vector<int>>& loops) {
  std::optional<std::vector<Triangle>> result = Ears(points, loops).cut();
  if (result) flip(points, loops, *result);
  return result;
}

}  // namespace isopatch::segmentation::planar
