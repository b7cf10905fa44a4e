#include "segmentation/profiles/internal/ring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "segmentation/profiles/internal/cell_shape.hpp"
#include "segmentation/profiles/internal/triangulate.hpp"
#include "segmentation/profiles/internal/window.hpp"

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;
using std::numbers::pi;

double room_along(const Vector2d& corner, const Vector2d& way, double half_angle,
                  const std::vector<Vector2d>& outline) {
  const double sine = 0.95 * std::sin(half_angle);
  double result = refused;
  for (const Vector2d& point : outline) {
    const Vector2d to = point - corner;
    const double along = to.dot(way), root = along * along - to.squaredNorm() * (1 - sine * sine);
    if (along > 0 && root >= 0) result = std::min(result, to.squaredNorm() / (along + std::sqrt(root)));
  }
  return result;
}

std::optional<CellMesh> ring_start(const std::vector<Curve>& curves, const CellMesh& region,
                                   const std::vector<bool>& shared) {
  constexpr double straight = 120 * pi / 180, share = 0.4;
  std::vector<int> cells(region.cells.size());
  std::iota(cells.begin(), cells.end(), 0);
  const auto loops = loops_of(curves, region, Neighbours(region), cells, shared);
  if (loops.size() != 1 || loops.front().size() < 5) return std::nullopt;
  const std::vector<Place>& places = loops.front();
  const std::size_t count = places.size();
  std::vector<SideShape> shapes;
  std::vector<Vector2d> outline;
  for (const Place& place : places) {
    if (place.link.curve < 0 || !shared[static_cast<std::size_t>(place.link.curve)]) return std::nullopt;
    shapes.push_back(side_shape(curves, region.nodes, place.link));
    for (int s = 0; s + 1 < SideShape::samples; ++s) outline.push_back(shapes.back().point(s));
  }
  CellMesh result{region.nodes, {}};
  std::vector<int> inner;
  for (std::size_t i = 0; i < count; ++i) {
    const double out = shapes[i].start_direction, in = shapes[(i + count - 1) % count].end_direction + pi;
    const double half = angle_between(out, in) / 2;
    if (2 * half < straight) return std::nullopt;
    const Vector2d corner = region.nodes[places[i].node].point,
                   way(std::cos(out + half), std::sin(out + half));
    const double room = room_along(corner, way, half, outline);
    if (!(room < refused)) return std::nullopt;
    inner.push_back(static_cast<int>(result.nodes.size()));
    result.nodes.push_back({corner + share * room * way, false, -1, 0});
  }
  const int number = region.cells.front().region;
  for (std::size_t i = 0; i < count; ++i) {
    const int next = inner[(i + 1) % count];
    const Side& side = places[i].link;
    result.cells.push_back(
        {number, 4, {side, Side{side.to, next}, Side{next, inner[i]}, Side{inner[i], side.from}}});
  }
  std::vector<Vector2d> points;
  for (const Node& node : result.nodes) points.push_back(node.point);
  const auto core = triangulate(points, {inner});
  if (!core) return std::nullopt;
  for (const std::array<int, 3>& c : *core)
    result.cells.push_back({number, 3, {Side{c[0], c[1]}, Side{c[1], c[2]}, Side{c[2], c[0]}, Side{}}});
  return result;
}

}  // namespace isopatch::segmentation::planar
