#include "segmentation/parameterization/triangulation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "geometry/base/error.hpp"
#include "segmentation/parameterization/outline.hpp"

namespace isopatch::segmentation {
namespace {

using Triangle = std::array<int, 3>;
using Points = std::vector<Eigen::Vector2d>;

const Eigen::Vector2d& at(const Points& points, int i) {
  return points[static_cast<std::size_t>(i)];
}

double area(const Points& points, int a, int b, int c) {
  return doubled_area(at(points, a), at(points, b), at(points, c));
}

// Sine-like measure of the smallest angle: least height over longest side. Negative for a turned triangle.
double shape(const Points& points, int a, int b, int c) {
  const double longest =
      std::max({(at(points, a) - at(points, b)).squaredNorm(), (at(points, b) - at(points, c)).squaredNorm(),
                (at(points, c) - at(points, a)).squaredNorm()});
  return area(points, a, b, c) / longest;
}

bool inside(const Points& points, const Triangle& t, const Eigen::Vector2d& p) {
  for (int k = 0; k < 3; ++k)
    if (doubled_area(at(points, t[static_cast<std::size_t>(k)]),
                     at(points, t[static_cast<std::size_t>((k + 1) % 3)]), p) < 0)
      return false;
  return true;
}

std::vector<Triangle> cut_ears(const Points& points) {
  std::vector<int> ring(points.size());
  std::iota(ring.begin(), ring.end(), 0);
  std::vector<Triangle> result;
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    double best = -1;
    std::size_t ear = n;
    for (std::size_t i = 0; i < n; ++i) {
      const Triangle t{ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]};
      const double quality = shape(points, t[0], t[1], t[2]);
      if (quality <= best || quality < 0) continue;
      const bool empty = std::none_of(ring.begin(), ring.end(), [&](int v) {
        return v != t[0] && v != t[1] && v != t[2] && inside(points, t, at(points, v));
      });
      if (!empty) continue;
      best = quality;
      ear = i;
    }
    if (ear == n)
      throw Error(ErrorCode::internal, "a face's outline cannot be triangulated: it crosses itself");
    result.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  result.push_back({ring[0], ring[1], ring[2]});
  return result;
}

/// The triangles to the left of each directed edge, with the corner across.
using EdgeMap = std::map<std::pair<int, int>, std::pair<std::size_t, int>>;

EdgeMap edge_map(const std::vector<Triangle>& triangles) {
  EdgeMap map;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      map[{triangles[t][k], triangles[t][(k + 1) % 3]}] = {t, triangles[t][(k + 2) % 3]};
  return map;
}

// One round over all edges, no triangle touched twice. Returns whether one was flipped.
bool flip_round(const Points& points, std::vector<Triangle>& triangles) {
  const EdgeMap map = edge_map(triangles);
  std::vector<bool> touched(triangles.size(), false);
  bool flipped = false;
  for (const auto& [edge, left] : map) {
    const auto [a, b] = edge;
    if (a > b) continue;
    const auto other = map.find({b, a});
    if (other == map.end()) continue;
    const auto [right_triangle, d] = other->second;
    const auto [left_triangle, c] = left;
    if (touched[left_triangle] || touched[right_triangle]) continue;
    const double now = std::min(shape(points, a, b, c), shape(points, b, a, d));
    const double then = std::min(shape(points, a, d, c), shape(points, d, b, c));
    if (then <= now + 1e-12) continue;
    triangles[left_triangle] = {a, d, c};
    triangles[right_triangle] = {d, b, c};
    touched[left_triangle] = touched[right_triangle] = flipped = true;
  }
  return flipped;
}

void insert(Triangulation& mesh, const Eigen::Vector2d& p) {
  for (Triangle& t : mesh.triangles) {
    if (!inside(mesh.points, t, p)) continue;
    const int v = static_cast<int>(mesh.points.size());
    mesh.points.push_back(p);
    const Triangle old = t;
    t = {old[0], old[1], v};
    mesh.triangles.push_back({old[1], old[2], v});
    mesh.triangles.push_back({old[2], old[0], v});
    return;
  }
}

// Points of a triangular grid, except those close to the outline.
Points inner_grid(const Points& outline, int count) {
  Eigen::AlignedBox2d box;
  double doubled = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
    box.extend(a);
    doubled += a[0] * b[1] - a[1] * b[0];
  }
  const double h = std::sqrt(std::abs(doubled) / 2 / std::max(count, 1));
  Points result;
  int row = 0;
  for (double y = box.min()[1] + 0.4567 * h; y < box.max()[1]; y += 0.866 * h, ++row)
    for (double x = box.min()[0] + (0.2345 + 0.5 * (row % 2)) * h; x < box.max()[0]; x += h) {
      const Eigen::Vector2d p(x + 0.01 * h * std::sin(7.0 * row), y);
      const bool clear = std::all_of(outline.begin(), outline.end(),
                                     [&](const auto& q) { return (p - q).squaredNorm() > 0.2 * h * h; });
      if (clear) result.push_back(p);
    }
  return result;
}

}  // namespace

Triangulation triangulate(const std::vector<Eigen::Vector2d>& outline, int inner_points) {
  Triangulation mesh{outline, cut_ears(outline), static_cast<int>(outline.size())};
  constexpr int most_rounds = 200;
  for (int i = 0; i < most_rounds && flip_round(mesh.points, mesh.triangles); ++i) {
  }
  for (const Eigen::Vector2d& p : inner_grid(outline, inner_points)) insert(mesh, p);
  for (int i = 0; i < most_rounds && flip_round(mesh.points, mesh.triangles); ++i) {
  }
  return mesh;
}

void divide_edges(Triangulation& mesh, const std::function<bool(int, int)>& divide) {
  for (bool found = true; found;) {
    found = false;
    const EdgeMap map = edge_map(mesh.triangles);
    std::vector<bool> touched(mesh.triangles.size(), false);
    for (const auto& [edge, left] : map) {
      const auto [a, b] = edge;
      const auto other = map.find({b, a});
      if (a > b || other == map.end() || !divide(a, b)) continue;
      const auto [right_triangle, d] = other->second;
      const auto [left_triangle, c] = left;
      if (touched[left_triangle] || touched[right_triangle]) {
        found = true;
        continue;
      }
      const int m = static_cast<int>(mesh.points.size());
      mesh.points.push_back((at(mesh.points, a) + at(mesh.points, b)) / 2);
      mesh.triangles[left_triangle] = {a, m, c};
      mesh.triangles[right_triangle] = {b, m, d};
      mesh.triangles.push_back({m, b, c});
      mesh.triangles.push_back({m, a, d});
      touched[left_triangle] = touched[right_triangle] = true;
    }
  }
}

}  // namespace isopatch::segmentation
